// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>

namespace dyncal {

/// Significant digits of a value whose uncertainty is not known: more would claim to know it better
/// than 0.5 %.
inline constexpr int kDigitsWithoutUncertainty = 3;
/// Most significant digits of a setting or a reading, which is quoted and not claimed.
inline constexpr int kDigitsOfSettings = 4;

/// A value and its uncertainty as printed: the same unit, the same number of decimals.
struct RoundedValue
{
    std::string value; ///< "2.3301"
    std::string u; ///< "0.0012"; empty if not known
    std::string unit; ///< "MHz"
};

/// Rounds for print (GUM 7.2.6): u to two significant digits, the value to the decimal of the last
/// of them. Without a known u (not finite, not positive, or below 1e-12 of the value, where only
/// rounding errors are left) three significant digits. Units that take SI prefixes get the one that
/// brings the larger of |value| and u into 1..1000; outside 1e-18..1e18, and for other units
/// outside 1e-4..1e6, a power of ten stands before the unit. A value that is not finite is a dash
/// without unit.
/// A page where numbers are worked with may ask for more `digits`; a certificate never does.
RoundedValue roundedValue(
    double value, double u, std::string_view unit, int digits = kDigitsWithoutUncertainty);

/// `u` for print, where no less than `least` may stand (u in its two digits, or the next two digits
/// up if those are less). `least` not above 0: `u`.
double neverBelow(double u, double least);

/// "2.3301 MHz".
std::string roundedText(double value, double u, std::string_view unit);

/// A setting, a count or a reading, which has no uncertainty of its own: no more digits than it
/// has, at most `mostDigits`: "10 MHz", "101.1 kPa". Unit as in roundedText().
std::string settingText(double value, std::string_view unit, int mostDigits = kDigitsOfSettings);

/// Of which side of a bound the value lies: "above" a lower one.
enum class BoundSide { Lower, Upper };

/// A bound to three significant digits, rounded so that it stays true: a lower one down, an upper
/// one up. Unit as in roundedText().
std::string boundText(double value, BoundSide bound, std::string_view unit);

/// "2.3301 MHz (u = 0.0012 MHz)"; without a known u as roundedText.
std::string roundedTextWithU(double value, double u, std::string_view unit);

/// `value` with `decimals` digits behind the point; negative: rounded to tens, hundreds... Never
/// "-0"; not finite as numberText().
std::string fixedText(double value, int decimals);

} // namespace dyncal
