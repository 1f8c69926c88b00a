// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/d_si_unit.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

struct KnownUnit
{
    std::string_view word;
    const char *symbol; ///< "" = a number
    double factor;
};

// SI brochure (9th edition), tables 2, 4 and 8, as the D-SI spells them. A decibel or a neper is no
// multiple of anything, and stays unknown.
constexpr std::array kUnits{KnownUnit{"volt", "V", 1.0}, KnownUnit{"ampere", "A", 1.0},
    KnownUnit{"coulomb", "C", 1.0}, KnownUnit{"watt", "W", 1.0}, KnownUnit{"pascal", "Pa", 1.0},
    KnownUnit{"bar", "Pa", 1e5}, KnownUnit{"hertz", "Hz", 1.0}, KnownUnit{"radian", "rad", 1.0},
    KnownUnit{"degree", "rad", std::numbers::pi / 180.0},
    KnownUnit{"arcminute", "rad", std::numbers::pi / 10800.0},
    KnownUnit{"arcsecond", "rad", std::numbers::pi / 648000.0}, KnownUnit{"one", "", 1.0},
    KnownUnit{"percent", "", 0.01}, KnownUnit{"ppm", "", 1e-6}, KnownUnit{"metre", "m", 1.0},
    KnownUnit{"second", "s", 1.0}, KnownUnit{"minute", "s", 60.0}, KnownUnit{"hour", "s", 3600.0},
    KnownUnit{"day", "s", 86400.0}, KnownUnit{"kilogram", "kg", 1.0}, KnownUnit{"gram", "kg", 1e-3},
    KnownUnit{"tonne", "kg", 1e3}, KnownUnit{"newton", "N", 1.0}, KnownUnit{"joule", "J", 1.0},
    KnownUnit{"kelvin", "K", 1.0}, KnownUnit{"ohm", "ohm", 1.0}, KnownUnit{"siemens", "S", 1.0},
    KnownUnit{"farad", "F", 1.0}, KnownUnit{"henry", "H", 1.0}, KnownUnit{"tesla", "T", 1.0},
    KnownUnit{"weber", "Wb", 1.0}, KnownUnit{"mole", "mol", 1.0}, KnownUnit{"candela", "cd", 1.0},
    KnownUnit{"steradian", "sr", 1.0}};

constexpr std::array kPrefixes{std::pair{"yotta", 24}, std::pair{"zetta", 21}, std::pair{"exa", 18},
    std::pair{"peta", 15}, std::pair{"tera", 12}, std::pair{"giga", 9}, std::pair{"mega", 6},
    std::pair{"kilo", 3}, std::pair{"hecto", 2}, std::pair{"deca", 1}, std::pair{"deci", -1},
    std::pair{"centi", -2}, std::pair{"milli", -3}, std::pair{"micro", -6}, std::pair{"nano", -9},
    std::pair{"pico", -12}, std::pair{"femto", -15}, std::pair{"atto", -18},
    std::pair{"zepto", -21}, std::pair{"yocto", -24}};

/// The words behind the backslashes; nothing where the text has anything else.
std::vector<std::string_view> wordsOfUnit(std::string_view text)
{
    std::vector<std::string_view> words;
    if (!text.starts_with('\\'))
        return words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\\', 1), text.size());
        words.push_back(text.substr(1, end - 1));
        text.remove_prefix(end);
    }
    return words;
}

/// Without what cancels; nothing where its factor is beyond what a computer's numbers hold: 0 in
/// such a unit would be no number, and any other value 0.
std::optional<DSiUnit> withinRange(DSiUnit unit)
{
    std::erase_if(unit.powers, [](const auto &power) { return power.second == 0; });
    return std::isnormal(unit.factor) ? std::optional(std::move(unit)) : std::nullopt;
}

std::optional<int> powerOfTen(std::string_view word)
{
    const auto known
        = std::ranges::find_if(kPrefixes, [&](const auto &prefix) { return prefix.first == word; });
    return known == kPrefixes.end() ? std::nullopt : std::optional(known->second);
}

/// "tothe{-1}"
std::optional<int> exponentOf(std::string_view word)
{
    constexpr std::string_view kBegin = "tothe{";
    if (!word.starts_with(kBegin) || !word.ends_with('}'))
        return std::nullopt;
    const auto value = parseNumber(word.substr(kBegin.size(), word.size() - kBegin.size() - 1));
    constexpr double kLargest = 9.0;
    const bool isWhole = value && std::abs(*value) <= kLargest && std::floor(*value) == *value;
    return isWhole ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

/// One after the other: a prefix waits for its unit, an exponent belongs to the unit before it.
class UnitReader
{
public:
    bool take(std::string_view word)
    {
        if (const std::optional<int> ten = powerOfTen(word))
            return std::exchange(m_prefix, *ten) == 0;
        if (const std::optional<int> exponent = exponentOf(word))
            return raise(*exponent);
        if (word == "per")
            return std::exchange(m_sign, -1) == 1 && m_prefix == 0;
        const auto known = std::ranges::find(kUnits, word, &KnownUnit::word);
        if (known == kUnits.end())
            return false;
        add();
        m_last = *known;
        m_power.reset();
        return true;
    }

    std::optional<DSiUnit> finish()
    {
        if (!m_last || isUnitAwaited())
            return std::nullopt;
        add();
        return withinRange(std::move(m_unit));
    }

private:
    /// Behind a prefix or "per": neither ends a unit nor takes an exponent.
    bool isUnitAwaited() const { return m_prefix != 0 || m_sign != 1; }

    bool raise(int exponent)
    {
        const bool isFirst = !m_power;
        m_power = exponent;
        return m_last && isFirst && !isUnitAwaited();
    }

    /// What is complete goes into the unit.
    void add()
    {
        if (m_last) {
            const int power = m_signOfLast * m_power.value_or(1);
            m_unit.factor *= std::pow(m_last->factor * std::pow(10.0, m_prefixOfLast), power);
            if (*m_last->symbol != '\0')
                m_unit.powers[m_last->symbol] += power;
        }
        m_prefixOfLast = std::exchange(m_prefix, 0);
        m_signOfLast = std::exchange(m_sign, 1);
    }

    DSiUnit m_unit;
    std::optional<KnownUnit> m_last;
    std::optional<int> m_power; ///< of the last unit, where one is stated
    int m_prefix = 0, m_prefixOfLast = 0;
    int m_sign = 1, m_signOfLast = 1;
};

/// "pC": C and 10^-12.
struct PrefixedUnit
{
    std::string symbol; ///< "" = a number
    int ten = 0;
};

bool isKnownSymbol(std::string_view text)
{
    return std::ranges::any_of(
        kUnits, [&](const KnownUnit &unit) { return unit.factor == 1.0 && text == unit.symbol; });
}

std::optional<PrefixedUnit> prefixedUnit(std::string_view text)
{
    constexpr std::array kLetters{std::pair{"G", 9}, std::pair{"M", 6}, std::pair{"k", 3},
        std::pair{"m", -3}, std::pair{"\xC2\xB5", -6}, std::pair{"u", -6}, std::pair{"n", -9},
        std::pair{"p", -12}};
    if (text == "1")
        return PrefixedUnit{};
    if (!text.empty() && isKnownSymbol(text))
        return PrefixedUnit{std::string(text), 0};
    for (const auto &[letter, ten] : kLetters) {
        const std::string_view rest = text.starts_with(letter)
            ? text.substr(std::string_view(letter).size())
            : std::string_view();
        if (!rest.empty() && isKnownSymbol(rest))
            return PrefixedUnit{std::string(rest), ten};
    }
    return std::nullopt;
}

} // namespace

int DSiUnit::powerOf(const std::string &symbol) const
{
    const auto found = powers.find(symbol);
    return found == powers.end() ? 0 : found->second;
}

bool DSiUnit::isOf(const std::string &symbol) const
{
    return powers.size() == 1 && powerOf(symbol) == 1;
}

bool DSiUnit::isSensitivity() const
{
    const bool isPerAcceleration = powerOf("m") == -1 && powerOf("s") == 2;
    const int inputs = (powerOf("Pa") == -1 ? 1 : 0) + (powerOf("N") == -1 ? 1 : 0)
        + (isPerAcceleration ? 1 : 0);
    const std::size_t below = isPerAcceleration ? 2 : 1;
    const auto isOutput = [](const auto &power) {
        return power.second == 1
            && (power.first == "V" || power.first == "A" || power.first == "C");
    };
    const auto outputs = static_cast<std::size_t>(std::ranges::count_if(powers, isOutput));
    return inputs == 1 && outputs <= 1 && powers.size() == below + outputs;
}

std::string DSiUnit::symbol() const
{
    std::string above, below;
    for (const auto &[symbol, power] : powers) {
        const std::string raised
            = symbol + (std::abs(power) > 1 ? std::to_string(std::abs(power)) : std::string());
        if (power > 0)
            above += (above.empty() ? "" : " ") + raised;
        else
            below += "/" + raised;
    }
    return (above.empty() ? "1" : above) + below;
}

std::optional<DSiUnit> parseDSiUnit(std::string_view text)
{
    UnitReader reader;
    for (const std::string_view word : wordsOfUnit(text))
        if (!reader.take(word))
            return std::nullopt;
    return reader.finish();
}

std::optional<DSiUnit> unitOfSymbol(std::string_view text)
{
    DSiUnit unit;
    int power = 1;
    for (std::size_t at = 0; at <= text.size(); power = -1) {
        const std::size_t end = std::min(text.find('/', at), text.size());
        const std::optional<PrefixedUnit> one = prefixedUnit(text.substr(at, end - at));
        if (!one)
            return std::nullopt;
        unit.factor *= std::pow(10.0, power * one->ten);
        if (!one->symbol.empty())
            unit.powers[one->symbol] += power;
        at = end + 1;
    }
    return withinRange(std::move(unit));
}

std::optional<double> unitRatio(std::string_view from, std::string_view to)
{
    const std::optional<DSiUnit> first = unitOfSymbol(from), second = unitOfSymbol(to);
    if (!first || !second || first->powers != second->powers)
        return std::nullopt;
    return first->factor / second->factor;
}

} // namespace dyncal
