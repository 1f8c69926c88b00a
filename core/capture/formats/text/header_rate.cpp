// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/header_rate.h"

#include "core/base/ascii_text.h"
#include "core/base/number_text.h"
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

/// Words that make a line speak of another rate than that of the samples below it.
constexpr auto kOtherRates = std::to_array<std::string_view>({"max", "maximum", "maximal",
    "maximale", "min", "minimum", "minimal", "highest", "lowest", "not", "never", "possible",
    "supported", "available", "allowed", "limit", "requested", "desired", "wanted", "target",
    "preview", "display", "previous", "original", "former", "old", "default", "nicht", "kein",
    "keine", "inte", "ej", "ingen", "h\u00F6chste", "h\u00F6gsta", "l\u00E4gsta"});

/// "200 000", "200'000": what ISO 80000 lets stand between groups of three digits, and what stands
/// for it in print.
constexpr auto kGroupMarks
    = std::to_array<std::string_view>({" ", "'", "\u00A0", "\u2007", "\u2009", "\u202F", "\u2019"});

bool saysOtherRate(std::string_view text)
{
    while (!text.empty()) {
        std::size_t end = 0;
        while (end < text.size() && isWordCharacter(text[end]))
            ++end;
        if (std::find(kOtherRates.begin(), kOtherRates.end(), text.substr(0, end))
            != kOtherRates.end())
            return true;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return false;
}

/// The part of a line that belongs to what follows it.
std::string_view lastClause(std::string_view text)
{
    const std::size_t mark = text.find_last_of(",;|\t");
    return mark == std::string_view::npos ? text : text.substr(mark + 1);
}

std::size_t digitsAt(std::string_view text, std::size_t at)
{
    const std::size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
    return end - std::min(at, end);
}

/// Length of the mark between groups at this place, with three digits behind it; else 0.
std::size_t groupMarkAt(std::string_view text, std::size_t at, char separator)
{
    constexpr std::size_t kGroup = 3;
    for (const std::string_view mark : kGroupMarks)
        if (text.substr(at).starts_with(mark) && !(mark.size() == 1 && mark[0] == separator)
            && digitsAt(text, at + mark.size()) == kGroup)
            return mark.size();
    return 0;
}

/// Reads number and unit of the text after a key: "[us], 0,01", ": 10 MHz", "_hz = 1e6".
class ValueCursor
{
public:
    ValueCursor(std::string_view text, const TextDialect &dialect)
        : m_rest(text)
        , m_separator(dialect.separator)
        , m_commaSeparates(dialect.separator == ',')
        , m_decimal(dialect.decimal)
    {
    }

    /// Number and unit; false if one of them is in doubt.
    bool read(double &number, std::string &unit)
    {
        unit = leadingUnit();
        const Grouping grouping = joinGroups();
        if (saysOtherRate(unit) || grouping == Grouping::Unclear || !readNumber(number))
            return false;
        const std::string behind = word();
        if (!behind.empty())
            unit = behind;
        const bool isSure = grouping == Grouping::None || !unit.empty();
        return isSure && !saysOtherRate(m_rest.substr(0, m_rest.find_first_of(",;|\t")));
    }

private:
    enum class Grouping { None, Joined, Unclear };

    /// Takes the marks out of a number in groups of three digits. Unclear if its groups may as well
    /// be cells, or are of other lengths.
    Grouping joinGroups()
    {
        constexpr std::size_t kGroup = 3;
        skip(kBetween);
        std::size_t at = digitsAt(m_rest, 0);
        if (at == 0 || at > kGroup || m_rest[0] == '0')
            return Grouping::None;
        m_joined = std::string(m_rest.substr(0, at));
        while (const std::size_t mark = groupMarkAt(m_rest, at, m_separator)) {
            m_joined += m_rest.substr(at + mark, kGroup);
            at += mark + kGroup;
        }
        if (m_joined.size() <= kGroup)
            return groupMarkAt(m_rest, at, 0) > 0 ? Grouping::Unclear : Grouping::None;
        m_joined += m_rest.substr(at);
        m_rest = m_joined;
        return Grouping::Joined;
    }

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

    std::string m_joined; ///< the rest with the first number in one piece
    std::string_view m_rest;
    char m_separator;
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
            if (!matchesAt(line, at, key.words)
                || saysOtherRate(lastClause(std::string_view(line).substr(0, at))))
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
