// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

// For sentences, tables and files of numbers: NaN is written as a dash and infinity as its sign,
// never as "nan" or "inf", which a reader may take for words.

/// Shortest text that reads back as the same double, '.' as decimal mark whatever the locale.
std::string numberText(double value);

/// The same for text that a program reads back: "nan", "inf" and "-inf" where it is not finite.
std::string exactNumber(double value);

/// `digits` significant digits (1..17), '.' as decimal mark, exponent only outside 1e-4..1e15.
std::string numberText(double value, int digits);

/// Whether an SI prefix may stand before it: a unit that is known and has none yet ("Hz", "V/Pa";
/// not "mV", "kPa", "N/mm2", or what somebody typed).
bool takesSiPrefix(std::string_view unit);

/// Value with SI prefix and unit: numberWithUnit(2.33e6, "Hz", 3) == "2.33 MHz". 0 has no prefix;
/// the unit "1" (a pure number) has neither prefix nor text. Units that take no prefix get a power
/// of ten outside 1e-4..1e6: "1.5 x10^-7 mv/Pa", with the sign of multiplication.
std::string numberWithUnit(double value, std::string_view unit, int digits = 4);

/// Reads the whole of `text` as one number with decimal mark '.', independent of the locale.
/// Empty if anything is left over or nothing is there.
std::optional<double> parseNumber(std::string_view text);

/// Whether the mark in it may group thousands as well as mark decimals, where the decimal mark of
/// its surroundings is `decimal`: "50,000" among decimal points is fifty thousand to most writers,
/// fifty to some. `digits` begins without a sign.
bool mayBeGrouped(std::string_view digits, char decimal);

} // namespace dyncal
