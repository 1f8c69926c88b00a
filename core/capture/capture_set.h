// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/channel.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What is known of the sensors and the tube; free key -> text, SI units in the key.
using Attributes = std::map<std::string, std::string>;

enum class ShotLevel { None, Low, Medium, High };

const char *shotLevelName(ShotLevel level); ///< "low", "medium", "high", ""
ShotLevel shotLevelFromName(std::string_view name);

/// Surroundings of one shot as recorded; NaN = not recorded.
struct Environment
{
    double p1_Pa, u_p1_Pa, T1_K, u_T1_K, p4_Pa, T4_K, ambientPressure_Pa, ambientT_K,
        relativeHumidity;
    Environment(); ///< all not recorded
};

/// Where a shot came from.
struct InputFile
{
    std::string path; ///< as given
    std::string file; ///< base name
    std::string sha256; ///< of the file's bytes; empty until sealed
    std::string format; ///< name of the reader: "dyncal-capture", "lvm", "text"
    std::uintmax_t bytes = 0; ///< size when opened
    std::int64_t changed_ns = 0; ///< last change when opened, by the file system's clock
    std::optional<std::string> expectedSha256 = {}; ///< hash that a project states

    bool operator==(const InputFile &) const = default;
};

/// One burst, recorded on several channels that may differ in rate and length.
struct Shot
{
    std::string label;
    ShotLevel level = ShotLevel::None;
    std::vector<Channel> channels;
    Environment environment;
    Index input = 0; ///< position in CaptureSet::inputs
    Index inFile = 0; ///< number among the shots of its file, from 1; 0 = no file
    bool included = true;
    std::string excludeReason;
    Attributes notes; ///< what else the source says of the shot: "start_utc", "operator", "comment"

    /// The first channel of that role, or null.
    const Channel *channelWithRole(ChannelRole role) const;

    /// The channel of that name, else the first of the role of that name, or null.
    const Channel *channelCalled(const std::string &nameOrRole) const;
};

/// Position in CaptureSet::inputs of the file that this channel of the shot came from.
inline Index inputOf(const Shot &shot, const Channel &channel)
{
    return channel.input.value_or(shot.input);
}

/// Whether the shot, or a channel of it, came from this input.
bool comesFrom(const Shot &shot, Index input);

/// Updates the shot's positions in CaptureSet::inputs: p becomes `newPosition(p)`.
void moveInputs(Shot &shot, const std::function<Index(Index)> &newPosition);

/// All shots of one sensor, in order. Shot numbers shown to people count from 1 in this order.
struct CaptureSet
{
    std::vector<InputFile> inputs;
    std::vector<Shot> shots;
    Attributes tube; ///< e.g. "driver_length_m" -> "0.97"
    std::map<std::string, Attributes> sensors; ///< by sensor id
    std::map<std::string, Attributes> instruments;
    Findings findings; ///< raised while reading

    /// A finite number of `tube`, if it is there and is one.
    std::optional<double> tubeNumber(const std::string &key) const;
};

} // namespace dyncal
