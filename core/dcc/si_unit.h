// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// A printed unit in the D-SI (SmartCom, 2.2): "mV/kPa" is "\milli\volt\kilo\pascal\tothe{-1}", ""
/// and "1" are "\one". Empty where it is not known what the unit is, as of one that somebody typed:
/// "g" is a gram to some and an acceleration to others.
std::optional<std::string> dsiUnitOf(std::string_view printed);

/// Of two units as the D-SI writes them: "\hertz" over "\kelvin" is "\hertz\kelvin\tothe{-1}";
/// "\one" where both are the same.
std::string quotientOfUnits(const std::string &above, const std::string &below);

} // namespace dyncal
