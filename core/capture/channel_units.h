// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// A unit in terms of the SI unit of its kind.
struct SiUnit
{
    std::string unit; ///< "Pa" or "V"
    double factor = 1.0; ///< value in the SI unit of one such unit
};

/// Pressures (Pa, hPa, kPa, MPa, mbar, bar, psi) in Pa and voltages (V, mV, uV, kV, with either
/// sign for micro, and Volt, Volts, volt, volts) in V; empty for
/// every other unit, which then is left as it is. psi: 6894.757 Pa (NIST SP 811).
std::optional<SiUnit> siUnitOf(std::string_view unit);

/// The unit that a channel's name ends with, where it is one of these: "DUT_mV", "p5 in kPa",
/// "Side kPa". A "V" alone behind a blank may be a numeral, and is none.
std::optional<std::string> unitInName(std::string_view name);

} // namespace dyncal
