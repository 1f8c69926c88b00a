// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What another calibration states of the same sensor's sensitivity: a static one, or that of a
/// secondary standard at a frequency.
struct KnownSensitivity
{
    std::string label; ///< as the certificate names it: "static calibration"
    double frequency_Hz = 0.0; ///< 0 = static
    double magnitude = 0.0; ///< in `unit`
    double u = 0.0; ///< standard uncertainty (k = 1), in `unit`
    std::string unit; ///< "V/Pa", "mV/bar"; its denominator a pressure
    std::optional<double> dof = {}; ///< of u; absent = many
    std::string certificate = {}; ///< number, "" = none
    bool operator==(const KnownSensitivity &) const = default;
};

/// Recipe section "response".
struct ResponseSettings
{
    std::vector<double> frequencies_Hz; ///< used when `grid` is "list"
    std::string grid = "third-octave"; ///< "list", "third-octave" or "linear"
    Index linearCount = 200; ///< with "linear:N"
    std::string reference = "computed-step"; ///< or "static-sensitivity", "unit-step", "transducer"
    std::vector<KnownSensitivity> known = {}; ///< compared with S(f), and joined to it within U

    bool isByTransducer() const { return reference == "transducer"; }
    bool operator==(const ResponseSettings &) const = default;
};

} // namespace dyncal
