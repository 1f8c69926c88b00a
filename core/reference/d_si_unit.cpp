// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/d_si_unit.h"

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

constexpr std::array kUnits{KnownUnit{"volt", "V", 1.0}, KnownUnit{"ampere", "A", 1.0},
    KnownUnit{"coulomb", "C", 1.0}, KnownUnit{"watt", "W", 1.0}, KnownUnit{"pascal", "Pa", 1.0},
    KnownUnit{"bar", "Pa", 1e5}, KnownUnit{"hertz", "Hz", 1.0}, KnownUnit{"radian", "rad", 1.0},
    KnownUnit{"degree", "rad", std::numbers::pi / 180.0}, KnownUnit{"one", "", 1.0},
    KnownUnit{"percent", "", 0.01}};

constexpr std::array kPrefixes{std::pair{"tera", 12}, std::pair{"giga", 9}, std::pair{"mega", 6},
    std::pair{"kilo", 3}, std::pair{"hecto", 2}, std::pair{"deca", 1}, std::pair{"deci", -1},
    std::pair{"centi", -2}, std::pair{"milli", -3}, std::pair{"micro", -6}, std::pair{"nano", -9},
    std::pair{"pico", -12}, std::pair{"femto", -15}};

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
        std::erase_if(m_unit.powers, [](const auto &power) { return power.second == 0; });
        return m_unit;
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

} // namespace

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

} // namespace dyncal
