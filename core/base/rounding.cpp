// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/rounding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace dyncal {

namespace {

constexpr int kUncertaintyDigits = 2;
constexpr int kExactDigits = 17;
constexpr std::array<const char *, 9> kPrefixes{"f", "p", "n", "\xC2\xB5", "m", "", "k", "M", "G"};
constexpr int kUnityPlace = 5;

/// Decimal exponent after rounding to `digits` significant digits: 9.996 with 3 digits has 1.
int exponentAfterRounding(double magnitude, int digits)
{
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude,
        std::chars_format::scientific, digits - 1);
    const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
    const std::size_t mark = text.find('e');
    const std::size_t from = mark + (text[mark + 1] == '+' ? 2 : 1);
    int exponent = 0;
    std::from_chars(text.data() + from, text.data() + text.size(), exponent);
    return exponent;
}

bool takesPrefix(std::string_view unit)
{
    static constexpr std::array<std::string_view, 15> kUnits{"s", "Hz", "V", "A", "Pa", "C", "W",
        "N", "m", "m/s", "V/Pa", "A/Pa", "C/Pa", "W/Pa", "V/V"};
    return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

/// Power of ten that `value` is divided by, and how it is written before the unit.
struct Scale
{
    int exponent = 0;
    std::string symbol;
};

Scale chooseScale(double magnitude, int digits, std::string_view unit)
{
    if (magnitude == 0.0)
        return {};
    const int exponent = exponentAfterRounding(magnitude, digits);
    const int thousands = exponent >= 0 ? exponent / 3 : -((2 - exponent) / 3);
    if (takesPrefix(unit)) {
        const int place = std::clamp(thousands + kUnityPlace, 0, 8);
        return {3 * (place - kUnityPlace), kPrefixes[static_cast<std::size_t>(place)]};
    }
    if (exponent >= -4 && exponent < 6)
        return {};
    return {exponent,
        "\xC3\x97"
        "10^"
            + std::to_string(exponent) + (unit.empty() ? "" : " ")};
}

double scaled(double value, int exponent)
{
    // Dividing by a positive power of ten is exact in more cases than multiplying by its inverse.
    return exponent >= 0 ? value / std::pow(10.0, exponent) : value * std::pow(10.0, -exponent);
}

std::string withUnit(const std::string &number, const std::string &unit)
{
    return unit.empty() ? number : number + " " + unit;
}

} // namespace

std::string fixedText(double value, int decimals)
{
    if (decimals < 0) {
        const double grain = std::pow(10.0, -decimals);
        value = std::round(value / grain) * grain;
        decimals = 0;
    }
    // The largest double has 309 digits before the point.
    std::array<char, 400> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
        std::chars_format::fixed, std::min(decimals, 60));
    std::string text(buffer.data(), end.ptr);
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    if (zero && text.front() == '-')
        text.erase(0, 1);
    return text;
}

RoundedValue roundedValue(double value, double u, std::string_view unit)
{
    const bool known = std::isfinite(u) && u > 0.0;
    const int digits = known ? kUncertaintyDigits : kDigitsWithoutUncertainty;
    const double leading = known ? std::max(std::abs(value), u) : std::abs(value);
    int leadingDigits = digits;
    if (known)
        leadingDigits += std::clamp(exponentAfterRounding(leading, kExactDigits)
                - exponentAfterRounding(u, kUncertaintyDigits),
            0, kExactDigits - kUncertaintyDigits);
    const Scale scale = chooseScale(leading, leadingDigits, unit);
    const double shown = scaled(value, scale.exponent);

    RoundedValue result;
    result.unit = scale.symbol + std::string(unit);
    int decimals = 0;
    if (known) {
        const double shownU = scaled(u, scale.exponent);
        decimals = digits - 1 - exponentAfterRounding(shownU, digits);
        result.u = fixedText(shownU, decimals);
    } else if (shown != 0.0) {
        decimals = digits - 1 - exponentAfterRounding(std::abs(shown), digits);
    }
    result.value = fixedText(shown, decimals);
    return result;
}

std::string roundedText(double value, double u, std::string_view unit)
{
    const RoundedValue rounded = roundedValue(value, u, unit);
    return withUnit(rounded.value, rounded.unit);
}

std::string roundedTextWithU(double value, double u, std::string_view unit)
{
    const RoundedValue rounded = roundedValue(value, u, unit);
    const std::string text = withUnit(rounded.value, rounded.unit);
    return rounded.u.empty() ? text : text + " (u = " + withUnit(rounded.u, rounded.unit) + ")";
}

} // namespace dyncal
