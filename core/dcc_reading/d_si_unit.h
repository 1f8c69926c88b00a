// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// A unit of the D-SI (2.2.1, unit strings of the SmartCom project): a factor and powers of units
/// without prefix.
struct DSiUnit
{
    double factor = 1.0;
    std::map<std::string, int> powers; ///< by symbol: {"V", 1}, {"Pa", -1}

    /// "V/Pa", "rad", "1": units in alphabetical order, those below the line behind a slash each.
    std::string symbol() const;
    int powerOf(const std::string &symbol) const; ///< 0 where it is not in it
    bool isOf(const std::string &symbol) const; ///< the unit itself, as "Hz" or "rad"
    /// V, A, C or a number per pressure (Pa), force (N) or acceleration (m/s2).
    bool isSensitivity() const;
};

/// Reads such as "\volt\mega\pascal\tothe{-1}" or "\volt\per\mega\pascal". Empty where it is
/// malformed or names a unit that is not known, of units that are no multiple of one of the SI
/// (degrees Celsius, decibel), and where its factor is beyond 1e-307 to 1e308.
std::optional<DSiUnit> parseDSiUnit(std::string_view text);

/// The same of a unit as recipes and results write it: "V/Pa", "pC/Pa", "1".
std::optional<DSiUnit> unitOfSymbol(std::string_view text);

/// What a number in the first unit is multiplied by to be in the second, both as unitOfSymbol()
/// reads them; empty where one is not known, or they are of different quantities.
std::optional<double> unitRatio(std::string_view from, std::string_view to);

} // namespace dyncal
