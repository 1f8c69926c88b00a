// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/si_unit.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

struct Symbol
{
    std::string_view printed;
    std::string_view word;
};

constexpr std::array kSymbols{Symbol{"Hz", "\\hertz"}, Symbol{"s", "\\second"},
    Symbol{"V", "\\volt"}, Symbol{"A", "\\ampere"}, Symbol{"C", "\\coulomb"}, Symbol{"W", "\\watt"},
    Symbol{"Pa", "\\pascal"}, Symbol{"bar", "\\bar"}, Symbol{"N", "\\newton"},
    Symbol{"m", "\\metre"}, Symbol{"K", "\\kelvin"}, Symbol{"rad", "\\radian"},
    Symbol{"\xC2\xB0", "\\degree"},
    Symbol{"\xC2\xB0"
           "C",
        "\\degreeCelsius"},
    Symbol{"%", "\\percent"}, Symbol{"dB", "\\deci\\bel"}};

constexpr std::array kPrefixesOfUnits{Symbol{"G", "\\giga"}, Symbol{"M", "\\mega"},
    Symbol{"k", "\\kilo"}, Symbol{"h", "\\hecto"}, Symbol{"c", "\\centi"}, Symbol{"m", "\\milli"},
    Symbol{"\xC2\xB5", "\\micro"}, Symbol{"\xCE\xBC", "\\micro"}, Symbol{"u", "\\micro"},
    Symbol{"n", "\\nano"}, Symbol{"p", "\\pico"}, Symbol{"f", "\\femto"}};

/// Only these have prefixes: nobody prints millipercent.
constexpr std::string_view kNeverPrefixed = "\\percent\\degree\\degreeCelsius\\deci\\bel";

std::string_view wordOf(std::string_view symbol)
{
    const auto known = std::ranges::find(kSymbols, symbol, &Symbol::printed);
    return known == kSymbols.end() ? std::string_view() : known->word;
}

/// "kPa"; empty: not known.
std::string withPrefix(std::string_view symbol)
{
    if (const std::string_view plain = wordOf(symbol); !plain.empty())
        return std::string(plain);
    for (const Symbol &prefix : kPrefixesOfUnits) {
        if (!symbol.starts_with(prefix.printed))
            continue;
        const std::string_view unit = wordOf(symbol.substr(prefix.printed.size()));
        if (!unit.empty() && kNeverPrefixed.find(unit) == std::string_view::npos)
            return std::string(prefix.word).append(unit);
    }
    return {};
}

/// "s2" below the line: "\second\tothe{-2}"
std::string factorOf(std::string_view factor, bool isBelow)
{
    int power = 1;
    const char last = factor.empty() ? ' ' : factor.back();
    if (factor.size() > 1 && last >= '2' && last <= '9') {
        power = last - '0';
        factor.remove_suffix(1);
    }
    std::string word = withPrefix(factor);
    if (!word.empty() && (isBelow || power > 1))
        word.append("\\tothe{").append(std::to_string(isBelow ? -power : power)).append("}");
    return word;
}

/// Takes the next "\name" from the front.
std::string_view takeUnitWord(std::string_view &unit)
{
    const std::size_t end = std::min(unit.find('\\', 1), unit.size());
    const std::string_view word = unit.substr(0, end);
    unit.remove_prefix(end);
    return word;
}

/// "{2}" becomes "\tothe{-2}"; without the power of one.
std::string oppositePower(std::string_view braced)
{
    std::string power(braced.substr(1, braced.size() - 2));
    power = power.starts_with('-') ? power.substr(1) : "-" + power;
    return power == "1" ? std::string() : "\\tothe{" + power + "}";
}

} // namespace

std::optional<std::string> dsiUnitOf(std::string_view printed)
{
    if (printed.empty() || printed == "1")
        return "\\one";
    std::string unit;
    for (bool isBelow = false;; isBelow = true) {
        const std::size_t slash = std::min(printed.find('/'), printed.size());
        const std::string_view factor = printed.substr(0, slash);
        const std::string word = factorOf(factor, isBelow);
        if (word.empty() && (isBelow || factor != "1"))
            return std::nullopt;
        unit += word;
        if (slash == printed.size())
            return unit;
        printed.remove_prefix(slash + 1);
    }
}

std::string quotientOfUnits(const std::string &above, const std::string &below)
{
    constexpr std::string_view kPower = "\\tothe";
    if (above == below)
        return "\\one";
    if (below == "\\one")
        return above;
    std::string quotient = above == "\\one" ? std::string() : above;
    for (std::string_view left = below; !left.empty();) {
        const std::string_view word = takeUnitWord(left);
        quotient += word;
        if (std::ranges::find(kPrefixesOfUnits, word, &Symbol::word) != kPrefixesOfUnits.end())
            continue; // the power of a prefix is that of its unit
        quotient += left.starts_with(kPower)
            ? oppositePower(takeUnitWord(left).substr(kPower.size()))
            : "\\tothe{-1}";
    }
    return quotient;
}

} // namespace dyncal
