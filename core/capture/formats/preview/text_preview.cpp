// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/preview/text_preview.h"

#include "core/base/text_encoding.h"
#include "core/capture/channel_units.h"
#include "core/capture/formats/lvm/lvm.h"
#include "core/capture/formats/text/column_titles.h"
#include "core/capture/formats/text/shot_columns.h"
#include "core/capture/formats/text/table_import.h"
#include "core/capture/formats/text/text_bytes.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_table.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::size_t kBytes = std::size_t{1024} * 1024; ///< of the file that are looked at
constexpr std::size_t kRowsShown = 50;
constexpr Index kCellsShown = 1000; ///< of a row
constexpr std::size_t kCellBytes = 200;

/// The cells of the first rows as written, and how many of all rows hold what no import could use.
class PreviewRows
{
public:
    PreviewRows(const TextDialect &dialect, Index headerLines, TextPreview &preview)
        : m_dialect(dialect)
        , m_headerLines(headerLines)
        , m_preview(preview)
    {
    }

    void read(std::string_view text)
    {
        LineCursor lines(text);
        for (std::string_view line; lines.next(line);) {
            if (lines.number() > m_headerLines && !isBlankRow(line, m_dialect.separator)
                && !isCommentLine(line))
                addRow(line);
        }
    }

private:
    void addRow(std::string_view line)
    {
        ++m_preview.dataRows;
        const bool shown = m_preview.rows.size() < kRowsShown;
        if (shown)
            m_preview.rows.emplace_back();
        Index cells = 0;
        CellCursor cursor(line, m_dialect.separator);
        for (std::string_view cell; cursor.next(cell); ++cells) {
            double value = 0.0;
            const CellKind kind = readCell(cell, m_dialect.decimal, value);
            const bool extra = cells >= m_dialect.columns && kind != CellKind::Empty;
            if (extra || kind == CellKind::Unreadable)
                ++m_preview.unreadableCells;
            if (shown && cells < kCellsShown)
                m_preview.rows.back().push_back(utf8Text(cell.substr(0, kCellBytes)));
        }
        m_preview.unreadableCells += std::max<Index>(0, m_dialect.columns - cells);
    }

    const TextDialect &m_dialect;
    Index m_headerLines;
    TextPreview &m_preview;
};

void addTitles(TextPreview &preview, const std::vector<ColumnTitle> &titles)
{
    for (const ColumnTitle &title : titles) {
        preview.columnTitles.push_back(title.name);
        preview.units.push_back(
            title.unit.empty() ? unitInName(title.name).value_or("") : title.unit);
    }
}

constexpr const char *kNoTime = DYNCAL_TEXT(
    "core", "%1 states no sample rate and has no column of times; give the sample rate.");

/// First what would stop the import, then what may make numbers wrong, then the rate.
Message questionOf(
    const std::string &path, const Result<ImportedTable> &table, const ImportSettings &settings)
{
    if (!table)
        return table.error().message;
    for (const Finding &finding : table->findings) {
        if (finding.severity != Severity::Info)
            return finding.message;
    }
    const bool rateKnown = table->time.sampleRate_Hz > 0.0 || settings.sampleRate_Hz;
    return rateKnown ? Message() : Message{kNoTime, {path}};
}

} // namespace

Result<TextPreview> previewText(const std::string &path, const ImportSettings &settings)
{
    const Result<TextHead> head = readTextHead(path, kBytes);
    if (!head)
        return tl::unexpected(head.error());
    if (recogniseLvm(path, head->text) > 0)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is a LabVIEW measurement, which says itself how it is to be read; import it as lvm."),
                {path}},
            "CAP-001");
    const std::optional<TextDialect> dialect = dialectOf(head->text, settings);
    if (!dialect)
        return noRowsOfNumbers(path);
    TextPreview preview;
    preview.headerLines = dialect->headerLines();
    preview.separator = dialect->separator;
    preview.decimal = dialect->decimal;
    preview.encoding = head->encoding;
    preview.decimalAmbiguous = !dialect->ambiguous.empty();
    addTitles(preview, columnTitles(*dialect));
    const Result<ImportedTable> table
        = importTable({path, head->text, head->whole}, *dialect, settings, {});
    if (table) {
        preview.headerLines += table->countedHeaderLines;
        preview.timeColumn = table->time.column;
        preview.sampleRate_Hz = table->time.sampleRate_Hz;
        preview.glances.reserve(table->columns.size());
        for (const std::vector<double> &column : table->columns)
            preview.glances.push_back(glanceAt(std::span(column)));
    } else {
        preview.problem = table.error();
    }
    if (areColumnsShots(settings))
        preview.shots = shotsOfColumns(settings, dialect->columns, preview.timeColumn);
    preview.remark = questionOf(path, table, settings);
    preview.question = english(preview.remark);
    PreviewRows(*dialect, preview.headerLines, preview).read(head->text);
    return preview;
}

} // namespace dyncal
