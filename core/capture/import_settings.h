// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// ImportSettings::channelFiles: files of one recording become one shot.
inline constexpr const char *kJoinChannelFiles = "join";

/// ImportSettings::columnsAre: the columns of a text table are channels of one shot, or shots of
/// one sensor.
inline constexpr const char *kColumnsAreChannels = "channels";
inline constexpr const char *kColumnsAreShots = "shots";
/// The only channel of a shot that is a column: the recipe speaks of the sensor by this name.
inline constexpr const char *kShotColumnChannel = "DUT";

/// Default of ImportSettings::maxExpansion.
inline constexpr double kUsualExpansion = 20.0;

/// A shot taken out of the calibration, by number from 1, with the reason that the certificate
/// prints.
struct ExcludedShot
{
    Index shot = 0;
    std::string reason;
    bool operator==(const ExcludedShot &) const = default;
};

/// Roles of channels in one shot, by its number from 1: they win over those for its file and for
/// all.
struct ShotImport
{
    Index shot = 0;
    std::map<std::string, std::string> channels; ///< channel name -> role
    bool operator==(const ShotImport &) const = default;
};

/// The recipe's settings for one channel, besides its role; whatever is left out stays unchanged.
/// Values become polarity * scale * value / gain in `unit`; with a sensitivity they are divided by
/// it and become pressures in Pa.
struct ChannelImport
{
    std::optional<std::string> unit;
    std::optional<double> scale; ///< factor on the values
    std::optional<double> gain; ///< amplification between sensor and recorder
    std::optional<double> sensitivity; ///< of the sensor: SI unit of the channel (V) per Pa
    std::optional<int> polarity; ///< +1 or -1
    std::string reference; ///< "", "gauge" or "absolute"
    bool operator==(const ChannelImport &) const = default;
};

/// Settings for one file; whatever is left out is as for all files.
struct FileImport
{
    std::optional<std::string> format;
    std::map<std::string, Index> columns; ///< if any, they replace all columns stated for all files
    std::string columnsAre; ///< "" as for all files
    std::map<std::string, std::string> channels; ///< win name by name
    std::map<std::string, ChannelImport> channelDetails; ///< win name by name
    std::string decimal; ///< "" as for all files
    std::string separator; ///< "" as for all files
    std::optional<double> sampleRate_Hz;
    std::string sampleRateReason;
    std::optional<std::string> unit;
    std::optional<double> scale;
    std::optional<int> polarity;
    std::string reference;
    std::optional<Index> skipRows;
    std::optional<Index> interpolateInvalid;
    std::optional<double> maxExpansion;
    bool operator==(const FileImport &) const = default;
};

/// Recipe section "import": how files are read and what their channels are.
struct ImportSettings
{
    std::string format = "auto"; ///< "auto" or a reader's id
    std::map<std::string, Index>
        columns; ///< text files: role ("time", "dut", ...) -> column from 0
    std::string columnsAre = kColumnsAreChannels; ///< or "shots": see shot_columns.h
    std::map<std::string, std::string> channels; ///< channel name -> role
    std::map<std::string, ChannelImport> channelDetails; ///< channel name -> further settings
    std::string decimal = "auto"; ///< "auto", "." or ","
    std::string separator = "auto"; ///< "auto", ",", ";", "tab", "space", "|"
    std::optional<double> sampleRate_Hz; ///< overrides what the file says
    std::string sampleRateReason; ///< needed where it differs from what the file states
    std::optional<std::string> unit; ///< of the DUT
    double scale = 1.0; ///< factor on the DUT's values
    int polarity = 1; ///< +1 or -1, on the DUT
    std::string reference; ///< "", "gauge" or "absolute": the DUT's pressures
    std::optional<Index> skipRows; ///< text files: rows before the data
    Index interpolateInvalid = 0; ///< fill gaps of at most this many invalid samples
    double maxExpansion = kUsualExpansion; ///< memory for a file's content over the file's size
    std::string channelFiles = kJoinChannelFiles; ///< or "apart": see channel_files.h
    std::vector<std::string> levels; ///< one per shot: "low", "medium", "high" or ""
    std::vector<ExcludedShot> exclude;
    std::vector<ShotImport> shots; ///< at most one entry per shot
    std::map<std::string, FileImport> files; ///< base name -> settings for that file

    bool operator==(const ImportSettings &) const = default;
};

/// The settings for one file: those for all files, overridden by its own. `path` may have folders
/// before the base name.
ImportSettings settingsOfFile(const ImportSettings &settings, const std::string &path);

/// What is set for the channels of one shot alone (from 1), or null.
const std::map<std::string, std::string> *rolesOfShot(const ImportSettings &settings, Index shot);

} // namespace dyncal
