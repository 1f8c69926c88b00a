// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/rounding.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace dyncal {

namespace {

constexpr int kUncertaintyDigits = 2;
constexpr std::array<const char *, 9> kPrefixes{"f", "p", "n", "\xC2\xB5", "m", "", "k", "M", "G"};
constexpr int kUnityPlace = 5;
constexpr int kBeyondPrefixes = 18; ///< powers of ten, where "0.00001 fV" and "10000000 GHz" begin
constexpr double kFinestUncertainty = 1e-12; ///< of the value: less is rounding error

/// `magnitude` as "d.ddde+xx" with so many significant digits; all rounding is done here.
std::string scientificText(double magnitude, int digits)
{
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude,
        std::chars_format::scientific, digits - 1);
    return {buffer.data(), end.ptr};
}

double roundedTo(double value, int digits)
{
    return parseNumber(scientificText(value, digits)).value_or(value);
}

/// Decimal exponent of a rounded value: 1 for 10.0, even if its last bit is below.
int exponentOf(double magnitude)
{
    constexpr int kSureDigits = 15;
    const std::string text = scientificText(magnitude, kSureDigits);
    const std::size_t mark = text.find('e');
    const std::size_t from = mark + (text[mark + 1] == '+' ? 2 : 1);
    int exponent = 0;
    std::from_chars(text.data() + from, text.data() + text.size(), exponent);
    return exponent;
}

/// `value` to the decimal place 10^place.
double roundedToPlace(double value, int place)
{
    constexpr int kMostDigits = 17;
    const int digits = value == 0.0 ? 0 : exponentOf(std::abs(value)) - place + 1;
    if (digits >= 1)
        return roundedTo(value, std::min(digits, kMostDigits));
    const double grain = std::pow(10.0, place);
    return std::abs(value) > 0.5 * grain ? std::copysign(grain, value) : 0.0;
}

/// Power of ten that `value` is divided by, and how it is written before the unit.
struct Scale
{
    int exponent = 0;
    std::string symbol;
};

Scale chooseScale(double magnitude, std::string_view unit)
{
    if (magnitude == 0.0)
        return {};
    const int exponent = exponentOf(magnitude);
    const int thousands = exponent >= 0 ? exponent / 3 : -((2 - exponent) / 3);
    if (takesSiPrefix(unit) && std::abs(exponent) < kBeyondPrefixes) {
        const int place = std::clamp(thousands + kUnityPlace, 0, 8);
        return {3 * (place - kUnityPlace), kPrefixes[static_cast<std::size_t>(place)]};
    }
    if (!takesSiPrefix(unit) && exponent >= -4 && exponent < 6)
        return {};
    return {exponent,
        "\xC3\x97"
        "10^"
            + std::to_string(exponent) + (unit.empty() ? "" : " ")};
}

double scaled(double value, int exponent)
{
    // Dividing by a positive power of ten is exact in more cases than multiplying by its inverse.
    // In two parts where one factor would overflow.
    constexpr int kMost = 300;
    if (exponent < -kMost)
        return value * std::pow(10.0, kMost) * std::pow(10.0, -exponent - kMost);
    return exponent >= 0 ? value / std::pow(10.0, exponent) : value * std::pow(10.0, -exponent);
}

std::string withUnit(const std::string &number, const std::string &unit)
{
    return unit.empty() ? number : number + " " + unit;
}

/// A finite value to so many significant digits, without an uncertainty.
RoundedValue toDigits(double value, int digits, std::string_view unit)
{
    value = value == 0.0 ? 0.0 : roundedTo(value, digits);
    const int place = value == 0.0 ? 0 : exponentOf(std::abs(value)) - digits + 1;
    const Scale scale = chooseScale(std::abs(value), unit);
    return {fixedText(scaled(value, scale.exponent), value == 0.0 ? 0 : scale.exponent - place), {},
        scale.symbol + std::string(unit)};
}

/// The fewest significant digits, up to `most`, that `value` rounded to `most` has.
int digitsNeeded(double value, int most)
{
    const double target = roundedTo(value, most);
    int digits = 1;
    while (digits < most && roundedTo(value, digits) != target)
        ++digits;
    return digits;
}

} // namespace

std::string fixedText(double value, int decimals)
{
    if (!std::isfinite(value))
        return numberText(value);
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

RoundedValue roundedValue(double value, double u, std::string_view unit, int digits)
{
    if (!std::isfinite(value))
        return {"\xE2\x80\x93", {}, {}};
    // Rounded first, in the unit given: scaling first could change the direction in which a tie is
    // rounded, and 999.99 could become 1000 after the prefix was chosen.
    const bool known = std::isfinite(u) && u > kFinestUncertainty * std::abs(value);
    if (!known)
        return toDigits(value, digits, unit);
    u = roundedTo(u, kUncertaintyDigits);
    const int place = exponentOf(u) - kUncertaintyDigits + 1;
    value = roundedToPlace(value, place);
    const Scale scale = chooseScale(std::max(std::abs(value), u), unit);
    const int decimals = scale.exponent - place;

    RoundedValue result;
    result.unit = scale.symbol + std::string(unit);
    result.value = fixedText(scaled(value, scale.exponent), decimals);
    result.u = fixedText(scaled(u, scale.exponent), decimals);
    return result;
}

double neverBelow(double u, double least)
{
    constexpr double kRounding = 1e-9; // of the last digit: 0.015 is itself, whatever its last bit
    if (!(least > 0.0) || !(u > 0.0) || !std::isfinite(u))
        return u;
    const double grain = std::pow(10.0, exponentOf(u) - 1);
    if (std::round(u / grain) >= least / grain - kRounding)
        return u;
    return grain * std::ceil(least / grain - kRounding);
}

std::string roundedText(double value, double u, std::string_view unit)
{
    const RoundedValue rounded = roundedValue(value, u, unit);
    return withUnit(rounded.value, rounded.unit);
}

std::string settingText(double value, std::string_view unit, int mostDigits)
{
    if (!std::isfinite(value) || value == 0.0)
        return roundedText(value, 0.0, unit);
    const RoundedValue rounded = toDigits(value, digitsNeeded(value, mostDigits), unit);
    return withUnit(rounded.value, rounded.unit);
}

std::string boundText(double value, BoundSide bound, std::string_view unit)
{
    constexpr double kRounding = 1e-9; // of the last digit: 4e6 is itself, whatever its last bit
    if (!std::isfinite(value) || value == 0.0)
        return roundedText(value, 0.0, unit);
    const double grain
        = std::pow(10.0, exponentOf(std::abs(value)) - kDigitsWithoutUncertainty + 1);
    const double count = value / grain;
    const double whole
        = bound == BoundSide::Lower ? std::floor(count + kRounding) : std::ceil(count - kRounding);
    if (!std::isfinite(whole * grain)) // at the ends of what a double holds
        return roundedText(value, 0.0, unit);
    const RoundedValue rounded = toDigits(whole * grain, kDigitsWithoutUncertainty, unit);
    return withUnit(rounded.value, rounded.unit);
}

std::string roundedTextWithU(double value, double u, std::string_view unit)
{
    const RoundedValue rounded = roundedValue(value, u, unit);
    const std::string text = withUnit(rounded.value, rounded.unit);
    return rounded.u.empty() ? text : text + " (u = " + withUnit(rounded.u, rounded.unit) + ")";
}

} // namespace dyncal
