// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/text_preview.h"

#include "core/capture/formats/text_dialect.h"
#include "core/capture/formats/text_table.h"
#include "core/capture/formats/text_time.h"

#include <algorithm>
#include <limits>

namespace dyncal {
namespace {

constexpr std::size_t kBytes = 1024 * 1024; ///< of the file that are looked at
constexpr std::size_t kRowsShown = 50;

/// Reads what can be read and counts the rest, where the import would stop.
class PreviewRows
{
public:
    PreviewRows(const TextDialect &dialect, TextPreview &preview)
        : m_dialect(dialect)
        , m_preview(preview)
        , m_columns(static_cast<std::size_t>(dialect.columns))
    {
    }

    void read(std::string_view text)
    {
        LineCursor lines(text);
        for (std::string_view line; lines.next(line);) {
            if (lines.number() > m_dialect.headerLines())
                addRow(line);
        }
    }

    const std::vector<std::vector<double>> &columns() const { return m_columns; }

private:
    void addRow(std::string_view line)
    {
        if (isBlankRow(line, m_dialect.separator))
            return;
        const std::vector<std::string_view> cells = cellsOf(line, m_dialect.separator);
        for (std::size_t i = 0; i < std::max(cells.size(), m_columns.size()); ++i)
            addCell(i, i < cells.size() ? &cells[i] : nullptr);
        if (m_preview.rows.size() < kRowsShown) {
            std::vector<std::string> &row = m_preview.rows.emplace_back();
            for (const std::string_view cell : cells)
                row.push_back(utf8Text(cell));
        }
        ++m_preview.dataRows;
    }

    void addCell(std::size_t index, const std::string_view *cell)
    {
        double value = std::numeric_limits<double>::quiet_NaN();
        const CellKind kind
            = cell != nullptr ? readCell(*cell, m_dialect.decimal, value) : CellKind::Unreadable;
        const bool extra = index >= m_columns.size();
        if (kind == CellKind::Unreadable || (extra && kind == CellKind::Number))
            ++m_preview.unreadableCells;
        if (!extra)
            m_columns[index].push_back(value);
    }

    const TextDialect &m_dialect;
    TextPreview &m_preview;
    std::vector<std::vector<double>> m_columns;
};

void addTitles(TextPreview &preview, const std::vector<ColumnTitle> &titles)
{
    for (const ColumnTitle &title : titles) {
        preview.columnTitles.push_back(title.name);
        preview.units.push_back(title.unit);
    }
}

constexpr const char *kUnreadable = DYNCAL_TEXT("core",
    "%1 of the first cells are no numbers; check separator, decimal mark and the number of header "
    "lines.");
constexpr const char *kAmbiguous = DYNCAL_TEXT(
    "core", "\"%1\" can be read in two ways; choose the decimal mark and the separator.");
constexpr const char *kNoTime = DYNCAL_TEXT("core",
    "The file states no sample rate and has no column of times; give the "
    "sample rate.");

/// What stops the import comes first, then what makes numbers wrong.
std::string questionOf(const TextPreview &preview, const TextDialect &dialect,
    const Result<TextTime> &time, const ImportSettings &settings)
{
    if (preview.unreadableCells > 0)
        return english({kUnreadable, {std::to_string(preview.unreadableCells)}});
    if (!time)
        return english(time.error().message);
    if (preview.decimalAmbiguous)
        return english({kAmbiguous, {dialect.ambiguous}});
    for (const Finding &finding : time->findings) {
        if (finding.severity != Severity::Info)
            return english(finding.message);
    }
    return time->sampleRate_Hz > 0.0 || settings.sampleRate_Hz ? std::string()
                                                               : english({kNoTime, {}});
}

} // namespace

Result<TextPreview> previewText(const std::string &path, const ImportSettings &settings)
{
    const Result<TextHead> head = readTextHead(path, kBytes);
    if (!head)
        return tl::unexpected(head.error());
    const std::optional<TextDialect> dialect = dialectOf(head->text, settings);
    if (!dialect)
        return noRowsOfNumbers(path);
    TextPreview preview;
    preview.headerLines = dialect->headerLines();
    preview.separator = dialect->separator;
    preview.decimal = dialect->decimal;
    preview.encoding = head->encoding;
    preview.decimalAmbiguous = !dialect->ambiguous.empty();
    const std::vector<ColumnTitle> titles = columnTitles(*dialect);
    addTitles(preview, titles);
    PreviewRows rows(*dialect, preview);
    rows.read(head->text);
    const Result<TextTime> time = timeOfTable(path, settings, *dialect, titles, rows.columns());
    if (time) {
        preview.timeColumn = time->column;
        preview.sampleRate_Hz = time->sampleRate_Hz;
    }
    preview.question = questionOf(preview, *dialect, time, settings);
    return preview;
}

} // namespace dyncal
