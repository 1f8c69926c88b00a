// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// Pascals in one of a unit of pressure ("Pa", "kPa", "MPa", "hPa", "mbar", "bar", "psi"); empty
/// for any other unit. psi: 6894.757 (NIST SP 811).
std::optional<double> pascalsPer(std::string_view unit);

/// The unit of pressure in which `value` is within 10 % of `expected_Pa`, if there is one.
std::optional<std::string> unitThatFits(double value, double expected_Pa);

} // namespace dyncal
