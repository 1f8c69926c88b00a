// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/pressure_units.h"

#include "core/capture/channel_units.h"

#include <array>
#include <cmath>

namespace dyncal {
namespace {

constexpr std::array kUnits{"Pa", "kPa", "MPa", "hPa", "mbar", "bar", "psi"};
constexpr double kFits = 0.1;

} // namespace

std::optional<double> pascalsPer(std::string_view unit)
{
    const auto si = siUnitOf(unit);
    return si && si->unit == "Pa" ? std::optional(si->factor) : std::nullopt;
}

std::optional<std::string> unitThatFits(double value, double expected_Pa)
{
    for (const char *name : kUnits) {
        const double pascals = pascalsPer(name).value_or(1.0);
        if (std::abs(std::abs(value * pascals / expected_Pa) - 1.0) < kFits)
            return name;
    }
    return std::nullopt;
}

} // namespace dyncal
