// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/message.h"
#include "core/base/uncertain_value.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

inline constexpr double kUsualFactor = 2.0;

/// The coverage factor that U is stated with: 2, or Student's where few degrees of freedom ask for
/// more; 2 where it is not known.
double statedFactor(double k);

/// A result with its complete budget. `u` is complete or absent.
struct ReportedValue
{
    std::string of; ///< "sensitivity", "f0_hz", ...
    double value = kUnknown;
    std::string unit; ///< "" = a number
    std::vector<UncertaintyLine> lines = {};
    std::optional<double> u = {}; ///< k = 1, in `unit`
    double dof = kUnknown; ///< effective
    double k = kUnknown; ///< Student's factor of the 95 % interval
    Message missing = {}; ///< why `u` is absent
    double leastExpanded = 0.0; ///< below which U is not stated (CMC), in `unit`

    double factor() const { return statedFactor(k); } ///< that U is stated with
    std::optional<double> expanded() const; ///< U, in `unit`
    /// Of one of `lines`, in percent of the variance; negative where it is correlated with another
    /// that works against it.
    double sharePercent(const UncertaintyLine &line) const;
};

/// The line that brings U up to the laboratory's least one.
inline constexpr const char *kCapability = "cmc";

/// Fills u, dof and k in from the lines. All of them must be finite. Where U would be below
/// `leastExpanded`, a line kCapability makes up for what is missing (ILAC-P14, 5.4: no certificate
/// states less than the laboratory's CMC); one that stood there is replaced.
void combineLines(ReportedValue &reported);

} // namespace dyncal
