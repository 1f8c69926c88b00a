// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// A unit of the D-SI (SmartCom, 2.2): a factor and powers of units without prefix.
struct DSiUnit
{
    double factor = 1.0;
    std::map<std::string, int> powers; ///< by symbol: {"V", 1}, {"Pa", -1}

    /// "V/Pa", "rad", "1": units in alphabetical order, those below the line behind a slash each.
    std::string symbol() const;
};

/// Reads such as "\volt\mega\pascal\tothe{-1}" or "\volt\per\mega\pascal". Empty where it is
/// malformed or names a unit that no dynamic calibration of pressure sensors has.
std::optional<DSiUnit> parseDSiUnit(std::string_view text);

} // namespace dyncal
