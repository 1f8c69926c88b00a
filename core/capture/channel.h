// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/capture/raw_samples.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

enum class ChannelRole { Dut, DrivenSide, Driver, Trigger, Reference, Other };

/// "dut", "driven_side", "driver", "trigger", "reference", "other": the words of captures and
/// recipes.
const char *channelRoleName(ChannelRole role);

/// Reads a role; "velocity" and "driver_static" are older words for driven side and driver.
/// Unknown words are Other, as the capture layout demands.
ChannelRole channelRoleFromName(std::string_view name);

/// Whether the pressures of a channel are relative to ambient or to vacuum, where known.
enum class PressureReference { Unknown, Gauge, Absolute };

const char *pressureReferenceName(PressureReference reference); ///< "gauge", "absolute", ""

/// One channel of one shot: raw samples and what turns them into a physical quantity.
/// physical = polarity * scale * (polynomial or linear of the counts).
struct Channel
{
    std::string name;
    ChannelRole role = ChannelRole::Other;
    RawSamples samples;
    double sampleRate_Hz = 0.0; ///< 0 = unknown
    double t0_s = 0.0; ///< time of the first sample relative to the trigger
    std::vector<double> polynomial{0.0, 1.0}; ///< physical = sum polynomial[k] counts^k, ascending
    std::string unit = "V";
    std::string recordedUnit; ///< unit in the file if `unit` is now its SI unit; else empty
    std::string quantity;
    PressureReference reference = PressureReference::Unknown;
    double polarity = 1.0; ///< +1 or -1, set by the operator
    double userScale = 1.0; ///< further factor set by the operator (gain, sensitivity)
    std::optional<double> adcMin; ///< rails of the converter in counts, where the source says
    std::optional<double> adcMax;
    int adcBits = 0; ///< 0 = unknown
    std::string sensorId;
    std::optional<Index> input; ///< position in CaptureSet::inputs if it is not the shot's file
    std::string sha256; ///< of the samples (sha256OfSamples); empty until sealed
    std::string statedSha256; ///< hash that the file states; empty if it states none

    double duration_s() const { return static_cast<double>(samples.size()) / sampleRate_Hz; }
    double timeOf_s(Index sample) const
    {
        return t0_s + static_cast<double>(sample) / sampleRate_Hz;
    }
};

/// Physical value of one raw value of this channel.
double physicalValue(const Channel &channel, double raw);

/// Physical values of samples [begin, begin + count), which must lie within the record.
/// Non-finite samples stay non-finite; all are NaN if the samples' file cannot be read any more.
Eigen::VectorXd physicalValues(const Channel &channel, Index begin, Index count);

} // namespace dyncal
