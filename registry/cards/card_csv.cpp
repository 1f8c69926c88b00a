// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_csv.h"

#include "core/base/foreign_text.h"

#include <algorithm>
#include <set>

namespace dyncal {
namespace {

using Cells = std::vector<std::string>;

constexpr const char *kName = "name";

std::string cellOf(const std::string &text)
{
    // As presentable as in every table, with its line breaks: addresses have them.
    const bool isGuarded = spreadsheetText(text).starts_with('\'') && !text.starts_with('\'');
    const std::string shown = (isGuarded ? "'" : "") + presentable(text, LineBreaks::Keep);
    if (shown.find_first_of("\",;\n\r") == shown.npos)
        return shown;
    std::string quoted = "\"";
    for (const char c : shown)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string lineOf(const Cells &cells)
{
    std::string line;
    for (const std::string &cell : cells)
        line += (line.empty() && &cell == &cells.front() ? "" : ",") + cellOf(cell);
    return line + '\n';
}

/// Without the apostrophe that kept a spreadsheet from computing it.
std::string valueOf(const std::string &cell)
{
    const bool isGuarded = cell.size() > 1 && cell.front() == '\''
        && std::string_view("=+-@").find(cell[1]) != std::string_view::npos;
    return isGuarded ? cell.substr(1) : cell;
}

tl::unexpected<Error> wrongLine(std::size_t line, const char *why)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "Line %1 of the table of cards cannot be used: %2; correct it, nothing was changed."),
            {std::to_string(line), why}});
}

/// Takes the text apart; a quoted cell may hold separators, quotes (twice) and line breaks.
class CsvText
{
public:
    CsvText(const std::string &text, char separator)
        : m_text(text)
        , m_separator(separator)
    {
    }

    Result<std::vector<Cells>> lines()
    {
        while (m_at < m_text.size())
            if (!takeCell())
                return wrongLine(m_lines.size() + 1, "a quote is not closed");
        if (!m_cells.empty())
            endLine();
        return m_lines;
    }

private:
    bool takeCell()
    {
        std::string cell;
        if (m_text[m_at] == '"') {
            if (!takeQuoted(cell))
                return false;
        }
        while (m_at < m_text.size() && m_text[m_at] != m_separator && m_text[m_at] != '\n')
            cell += m_text[m_at++];
        if (!cell.empty() && cell.back() == '\r')
            cell.pop_back();
        m_cells.push_back(cell);
        if (m_at >= m_text.size() || m_text[m_at++] == '\n')
            endLine();
        else if (m_at == m_text.size())
            m_cells.emplace_back(); // an empty last cell
        return true;
    }

    bool takeQuoted(std::string &cell)
    {
        for (++m_at; m_at < m_text.size(); ++m_at) {
            if (m_text[m_at] == '"' && (m_at + 1 >= m_text.size() || m_text[m_at + 1] != '"')) {
                ++m_at;
                return true;
            }
            m_at += m_text[m_at] == '"' ? 1 : 0;
            cell += m_text[m_at];
        }
        return false;
    }

    void endLine()
    {
        m_lines.push_back(std::move(m_cells));
        m_cells.clear();
    }

    const std::string &m_text;
    char m_separator;
    std::size_t m_at = 0;
    Cells m_cells;
    std::vector<Cells> m_lines;
};

bool isEmpty(const Cells &cells)
{
    return std::ranges::all_of(cells, &std::string::empty);
}

Card cardOf(const Cells &titles, const Cells &cells, const std::string &kind)
{
    Card card{kind, {}, {}};
    for (std::size_t i = 0; i < titles.size(); ++i) {
        const std::string value = valueOf(cells[i]);
        if (titles[i] == kName)
            card.name = value;
        else if (!value.empty())
            card.fields[titles[i]] = value;
    }
    return card;
}

} // namespace

std::string cardsCsv(const std::vector<Card> &cards)
{
    std::set<std::string> fields;
    for (const Card &card : cards)
        for (const auto &[field, value] : card.fields)
            fields.insert(field);
    Cells titles{kName};
    titles.insert(titles.end(), fields.begin(), fields.end());
    std::string csv = lineOf(titles);
    for (const Card &card : cards) {
        Cells cells{card.name};
        for (const std::string &field : fields)
            cells.push_back(card.fields.contains(field) ? card.fields.at(field) : "");
        csv += lineOf(cells);
    }
    return csv;
}

Result<std::vector<Card>> parseCards(const std::string &csv, const std::string &kind)
{
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    const std::string text = csv.starts_with(kMark) ? csv.substr(kMark.size()) : csv;
    const std::string first = text.substr(0, text.find('\n'));
    const bool hasSemicolons = first.find(';') != first.npos && first.find(',') == first.npos;
    const auto lines = CsvText(text, hasSemicolons ? ';' : ',').lines();
    if (!lines)
        return tl::unexpected<Error>(lines.error());
    if (lines->empty() || std::ranges::count(lines->front(), kName) != 1)
        return wrongLine(1, "it needs one column with the title \"name\"");
    const Cells &titles = lines->front();
    std::vector<Card> cards;
    std::set<std::string> names;
    for (std::size_t i = 1; i < lines->size(); ++i) {
        const Cells &cells = (*lines)[i];
        if (isEmpty(cells))
            continue;
        if (cells.size() != titles.size())
            return wrongLine(i + 1, "it has not as many columns as the titles");
        cards.push_back(cardOf(titles, cells, kind));
        const std::string &name = cards.back().name;
        if (name.empty() || name.size() > kLongestCardName)
            return wrongLine(i + 1, "the name is missing or longer than 200 bytes");
        if (!names.insert(name).second)
            return wrongLine(i + 1, "the name is there twice");
    }
    return cards;
}

} // namespace dyncal
