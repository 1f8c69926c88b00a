// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A shot taken out of the calibration, by number from 1, with the reason that the certificate
/// prints.
struct ExcludedShot
{
    Index shot = 0;
    std::string reason;
    bool operator==(const ExcludedShot &) const = default;
};

/// Recipe section "import": how files are read and what their channels are.
struct ImportSettings
{
    std::string format = "auto"; ///< "auto" or a reader's id
    std::map<std::string, Index>
        columns; ///< text files: role ("time", "dut", ...) -> column from 0
    std::map<std::string, std::string> channels; ///< channel name -> role
    std::string decimal = "auto"; ///< "auto", "." or ","
    std::string separator = "auto"; ///< "auto", ",", ";", "tab", "space", "|"
    std::optional<double> sampleRate_Hz; ///< overrides what the file says
    std::optional<std::string> unit; ///< of the DUT
    double scale = 1.0; ///< factor on the DUT's values
    int polarity = 1; ///< +1 or -1, on the DUT
    std::string reference; ///< "", "gauge" or "absolute": the DUT's pressures
    std::optional<Index> skipRows; ///< text files: rows before the data
    Index interpolateInvalid = 0; ///< fill gaps of at most this many invalid samples
    std::vector<std::string> levels; ///< one per shot: "low", "medium", "high" or ""
    std::vector<ExcludedShot> exclude;

    bool operator==(const ImportSettings &) const = default;
};

} // namespace dyncal
