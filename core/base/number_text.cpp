// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace dyncal {

namespace {

/// Text for a number that is not finite: a dash for NaN.
std::string notFinite(double value)
{
    if (std::isnan(value))
        return "\xE2\x80\x93";
    return value > 0.0 ? "\xE2\x88\x9E" : "-\xE2\x88\x9E";
}

} // namespace

std::string numberText(double value)
{
    return std::isfinite(value) ? exactNumber(value) : notFinite(value);
}

std::string exactNumber(double value)
{
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

std::string numberText(double value, int digits)
{
    if (!std::isfinite(value))
        return notFinite(value);
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
        std::chars_format::general, std::clamp(digits, 1, 17));
    const std::string text(buffer.data(), end.ptr);
    // "general" uses an exponent from 10^digits on: 4.2e+02 for 420.
    if (text.find("e+") == std::string::npos || !(std::abs(value) < 1e15))
        return text;
    const double rounded = parseNumber(text).value_or(value);
    const auto plain = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), rounded, std::chars_format::fixed, 0);
    return {buffer.data(), plain.ptr};
}

bool takesSiPrefix(std::string_view unit)
{
    static constexpr std::array<std::string_view, 15> kUnits{"s", "Hz", "V", "A", "Pa", "C", "W",
        "N", "m", "m/s", "V/Pa", "A/Pa", "C/Pa", "W/Pa", "V/V"};
    return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

namespace {

/// "1.5 x10^-7 mv/Pa"
std::string withPowerOfTen(double value, std::string_view unit, int digits)
{
    constexpr double kLeast = 1e-4;
    constexpr double kMost = 1e6;
    const double magnitude = std::abs(value);
    std::string text;
    if (magnitude == 0.0 || !std::isfinite(value) || (magnitude >= kLeast && magnitude < kMost)) {
        text = numberText(value, digits);
    } else {
        std::array<char, 64> buffer;
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
            std::chars_format::scientific, std::clamp(digits, 1, 17) - 1);
        const std::string number(buffer.data(), end.ptr);
        const std::size_t mark = number.find('e');
        const int exponent = static_cast<int>(parseNumber(number.substr(mark + 1)).value_or(0.0));
        text = numberText(parseNumber(number.substr(0, mark)).value_or(0.0), digits)
            + " \xC3\x97"
              "10^"
            + std::to_string(exponent);
    }
    return text.append(" ").append(unit);
}

} // namespace

std::string numberWithUnit(double value, std::string_view unit, int digits)
{
    struct Prefix
    {
        double factor;
        const char *symbol;
    };
    static constexpr std::array<Prefix, 9> kPrefixes{{{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""},
        {1e-3, "m"}, {1e-6, "\xC2\xB5"}, {1e-9, "n"}, {1e-12, "p"}, {1e-15, "f"}}};
    if (unit == "1" || std::isnan(value))
        unit = {};
    if (!unit.empty() && !takesSiPrefix(unit))
        return withPowerOfTen(value, unit, digits);
    Prefix chosen{1.0, ""};
    if (std::isfinite(value) && value != 0.0 && !unit.empty()) {
        // Half a unit of the last digit up, so that 999.96 with 4 digits becomes 1.000 k.
        const double magnitude = std::abs(value) * (1.0 + 0.5 * std::pow(10.0, -digits));
        const auto fits = std::find_if(kPrefixes.begin(), kPrefixes.end(),
            [&](const Prefix &p) { return magnitude >= p.factor; });
        chosen = fits != kPrefixes.end() ? *fits : kPrefixes.back();
    }
    std::string text = numberText(value / chosen.factor, digits);
    if (!unit.empty())
        text.append(" ").append(chosen.symbol).append(unit);
    return text;
}

std::optional<double> parseNumber(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    double value = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size())
        return std::nullopt;
    return value;
}

bool mayBeGrouped(std::string_view digits, char decimal)
{
    constexpr std::size_t kGroup = 3;
    constexpr std::string_view kDigits = "0123456789";
    const std::size_t mark = digits.find_first_not_of(kDigits);
    if (mark == 0 || mark > kGroup || mark == std::string_view::npos || digits[0] == '0'
        || digits[mark] != (decimal == '.' ? ',' : '.'))
        return false;
    const std::string_view behind = digits.substr(mark + 1);
    const std::size_t end = std::min(behind.find_first_not_of(kDigits), behind.size());
    return end == kGroup && (end == behind.size() || behind[end] == digits[mark]);
}

} // namespace dyncal
