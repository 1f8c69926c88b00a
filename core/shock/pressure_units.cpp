// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/pressure_units.h"

#include <array>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

constexpr std::array<std::pair<const char *, double>, 7> kUnits{{{"Pa", 1.0}, {"kPa", 1e3},
    {"MPa", 1e6}, {"hPa", 100.0}, {"mbar", 100.0}, {"bar", 1e5}, {"psi", 6894.757}}};
constexpr double kFits = 0.1;

} // namespace

std::optional<double> pascalsPer(std::string_view unit)
{
    for (const auto &[name, pascals] : kUnits) {
        if (unit == name)
            return pascals;
    }
    return std::nullopt;
}

std::optional<std::string> unitThatFits(double value, double expected_Pa)
{
    for (const auto &[name, pascals] : kUnits) {
        if (std::abs(std::abs(value * pascals / expected_Pa) - 1.0) < kFits)
            return name;
    }
    return std::nullopt;
}

} // namespace dyncal
