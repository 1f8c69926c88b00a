// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// A number as the certificate prints it, digit by digit, ready for a DCC.
struct PrintedValue
{
    std::string value; ///< "2.3301", "1.5E-7"
    std::string unit; ///< D-SI
    std::string expanded = {}; ///< U, in the same unit; "" = none
    std::string factor = {}; ///< k of U; "" = as its column says

    bool operator==(const PrintedValue &) const = default;
};

/// "2.3301 MHz", "0.02", "1.5 x10^-7 V/Pa" (with the sign of multiplication), "2.33 MHz ± 0.12 MHz
/// (k = 2)", "0.12 MHz (k = 4.30)", whose number is then the value. Empty where it is anything
/// else: words, a bound, a dash, two numbers, or a unit that is not known.
std::optional<PrintedValue> printedValue(std::string_view text);

/// Of a cell or field that holds a number and nothing else. What was typed is no number, whatever
/// it looks like.
std::optional<PrintedValue> printedValue(const Message &cell);

} // namespace dyncal
