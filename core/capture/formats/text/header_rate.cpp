// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/header_rate.h"

#include "core/base/ascii_text.h"
#include "core/base/text_encoding.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_table.h"
#include "core/capture/formats/text/time_words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {
namespace {

constexpr std::size_t kLineBytes = 4096; ///< of a header line that are looked at
constexpr std::string_view kBetween = " \t:=;,|\"'"; ///< what stands between key, number and unit

enum class Kind { Rate, Interval };

struct Key
{
    std::string_view words;
    Kind kind;
};

constexpr auto kKeys
    = std::to_array<Key>({{"sample rate", Kind::Rate}, {"sampling rate", Kind::Rate},
        {"samplerate", Kind::Rate}, {"samplingrate", Kind::Rate}, {"sample frequency", Kind::Rate},
        {"sampling frequency", Kind::Rate}, {"samplingfrequency", Kind::Rate}, {"fs", Kind::Rate},
        {"abtastrate", Kind::Rate}, {"abtastfrequenz", Kind::Rate},
        {"samplingsfrekvens", Kind::Rate}, {"sample interval", Kind::Interval},
        {"sampling interval", Kind::Interval}, {"sampleinterval", Kind::Interval},
        {"sample period", Kind::Interval}, {"sampling period", Kind::Interval},
        {"time step", Kind::Interval}, {"timestep", Kind::Interval},
        {"time increment", Kind::Interval}, {"x increment", Kind::Interval},
        {"xincrement", Kind::Interval}, {"xinc", Kind::Interval}, {"delta t", Kind::Interval},
        {"delta x", Kind::Interval}, {"dt", Kind::Interval}, {"abtastintervall", Kind::Interval},
        {"abtastzeit", Kind::Interval}, {"samplingsintervall", Kind::Interval}});

bool isWordCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')
        || static_cast<unsigned char>(c) >= 0x80;
}

/// "50,000" above data with decimal points: thousands in most headers, thousandths in some.
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

/// Takes what a value is behind a key apart: "[us], 0,01", ": 10 MHz", "_hz = 1e6".
class ValueCursor
{
public:
    ValueCursor(std::string_view text, const TextDialect &dialect)
        : m_rest(text)
        , m_commaSeparates(dialect.separator == ',')
        , m_decimal(dialect.decimal)
    {
    }

    /// Number and unit, if both can be made out without doubt.
    bool read(double &number, std::string &unit)
    {
        unit = leadingUnit();
        if (!readNumber(number))
            return false;
        const std::string behind = word();
        if (!behind.empty())
            unit = behind;
        return true;
    }

private:
    void skip(std::string_view characters)
    {
        m_rest.remove_prefix(std::min(m_rest.find_first_not_of(characters), m_rest.size()));
    }

    std::string leadingUnit()
    {
        if (m_rest.starts_with('_')) {
            m_rest.remove_prefix(1);
            return word();
        }
        skip(" \t");
        const std::size_t close = m_rest.starts_with('[') ? m_rest.find(']')
            : m_rest.starts_with('(')                     ? m_rest.find(')')
                                                          : std::string_view::npos;
        if (close == std::string_view::npos)
            return {};
        std::string unit(trimmed(m_rest.substr(1, close - 1)));
        m_rest.remove_prefix(close + 1);
        return unit;
    }

    bool readNumber(double &number)
    {
        skip(kBetween);
        std::string_view digits = m_rest.substr(0, m_rest.find_first_not_of("0123456789+-.,e"));
        if (mayBeGrouped(digits, m_decimal))
            return false;
        const std::size_t comma = digits.find(',');
        if (m_commaSeparates || digits.find('.') < comma)
            digits = digits.substr(0, comma); // the cell ends there
        while (!digits.empty() && (digits.back() == ',' || digits.back() == 'e'))
            digits.remove_suffix(1);
        for (const char decimal : {'.', ','}) {
            if (readCell(digits, decimal, number) == CellKind::Number && std::isfinite(number)) {
                m_rest.remove_prefix(digits.size());
                return true;
            }
        }
        return false;
    }

    std::string word()
    {
        skip(kBetween);
        if (m_rest.starts_with('[') || m_rest.starts_with('('))
            m_rest.remove_prefix(1);
        const std::size_t end = std::min(m_rest.find_first_of(" \t:=;,|\"'])"), m_rest.size());
        std::string found(m_rest.substr(0, end));
        m_rest.remove_prefix(end);
        const bool number
            = !found.empty() && (found[0] == '-' || (found[0] >= '0' && found[0] <= '9'));
        return number ? std::string() : found; // the next cell
    }

    std::string_view m_rest;
    bool m_commaSeparates;
    char m_decimal;
};

std::optional<HeaderRate> rateOf(Kind kind, double number, const std::string &unit)
{
    if (!(number > 0.0))
        return std::nullopt;
    HeaderRate rate;
    rate.unitStated = !unit.empty();
    const std::optional<double> factor = unit.empty() ? 1.0
        : kind == Kind::Rate                          ? hertzPerUnit(unit)
                                                      : secondsPerUnit(unit);
    if (!factor)
        return std::nullopt;
    rate.rate_Hz = kind == Kind::Rate ? number * *factor : 1.0 / (number * *factor);
    const bool credible = rate.unitStated || rate.rate_Hz >= kCredibleRate_Hz;
    return credible && std::isfinite(rate.rate_Hz) ? std::optional(rate) : std::nullopt;
}

/// `words` as whole words, where the line may have underscores for blanks.
bool matchesAt(std::string_view line, std::size_t at, std::string_view words)
{
    if (line.size() - at < words.size() || (at > 0 && isWordCharacter(line[at - 1])))
        return false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char c = line[at + i] == '_' ? ' ' : line[at + i];
        if (c != words[i])
            return false;
    }
    const std::size_t end = at + words.size();
    return end == line.size() || !isWordCharacter(line[end]);
}

/// The statement that begins at the first key of the line.
std::optional<HeaderRate> rateInLine(std::string_view original, const TextDialect &dialect)
{
    const std::string line = lowerCase(utf8Text(original.substr(0, kLineBytes)));
    for (std::size_t at = 0; at < line.size(); ++at) {
        for (const Key &key : kKeys) {
            if (!matchesAt(line, at, key.words))
                continue;
            double number = 0.0;
            std::string unit;
            std::string_view behind = std::string_view(line).substr(at + key.words.size());
            if (!ValueCursor(behind, dialect).read(number, unit))
                continue;
            if (std::optional<HeaderRate> rate = rateOf(key.kind, number, unit))
                return rate;
        }
    }
    return std::nullopt;
}

/// Rigol writes "X,CH1,Start,Increment" and the values in the line below.
std::optional<HeaderRate> rateBelowTitle(
    std::string_view titles, std::string_view values, const TextDialect &dialect)
{
    const std::vector<std::string_view> names
        = cellsOf(titles.substr(0, kLineBytes), dialect.separator);
    const std::vector<std::string_view> cells
        = cellsOf(values.substr(0, kLineBytes), dialect.separator);
    for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) {
        double number = 0.0;
        if (lowerCase(std::string(names[i])) == "increment"
            && readCell(cells[i], dialect.decimal, number) == CellKind::Number)
            return rateOf(Kind::Interval, number, {});
    }
    return std::nullopt;
}

} // namespace

std::vector<HeaderRate> headerRates(const TextDialect &dialect)
{
    constexpr std::size_t kShown = 60;
    std::vector<HeaderRate> rates;
    for (std::size_t i = 0; i < dialect.header.size(); ++i) {
        std::optional<HeaderRate> rate = rateInLine(dialect.header[i], dialect);
        if (!rate && i + 1 < dialect.header.size())
            rate = rateBelowTitle(dialect.header[i], dialect.header[i + 1], dialect);
        if (!rate)
            continue;
        rate->line = static_cast<Index>(i) + 1;
        rate->text = utf8Text(trimmed(dialect.header[i].substr(0, kShown)));
        rates.push_back(std::move(*rate));
    }
    return rates;
}

} // namespace dyncal
