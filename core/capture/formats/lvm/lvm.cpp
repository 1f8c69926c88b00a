// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm/lvm.h"

#include "core/capture/formats/lvm/lvm_header.h"
#include "core/capture/formats/lvm/lvm_rows.h"
#include "core/capture/formats/lvm/lvm_shot.h"
#include "core/capture/formats/text/table_end.h"
#include "core/capture/formats/text/text_bytes.h"
#include "core/capture/formats/text/text_dialect.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

constexpr std::string_view kFirstWords = "LabVIEW Measurement";

constexpr Index kChannelBytes = 2; ///< least size of a segment's channel in the file

class LvmReader
{
public:
    LvmReader(const std::string &path, std::string_view text, const ImportSettings &settings,
        const JobControl &control)
        : m_path(path)
        , m_settings(settings)
        , m_control(control)
        , m_text(text)
        , m_budget(text.size(), settings.maxExpansion)
    {
        takeText();
    }

    Result<CaptureSet> read()
    {
        const std::string_view text = m_text;
        LineCursor lines(text);
        LvmTags tags;
        const char separator = lvmSeparator(text);
        if (!readLvmTags(lines, {}, separator, tags))
            return endsInHeader();
        m_file = lvmFileHeader(tags, separator);
        if (m_file.commaTwice)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1 uses the comma as separator and as decimal mark, so its numbers cannot be told apart; save it again with tabs as separator."),
                    {m_path}},
                "CAP-019");
        if (m_settings.decimal == "." || m_settings.decimal == ",")
            m_file.decimal = m_settings.decimal[0];
        for (std::string_view line; lines.next(line);) {
            if (isBlank(line))
                continue;
            if (const Result<void> segment = readSegment(lines, line); !segment)
                return tl::unexpected(segment.error());
        }
        if (m_set.shots.empty())
            return endsInHeader();
        nameShots();
        return std::move(m_set);
    }

private:
    /// Counts the text itself and the numbers in it, without failing: they are no mere claim.
    void takeText()
    {
        constexpr std::uint64_t kTimes = 6;
        m_budget.take(std::min(kTimes * m_text.size(), m_budget.allowed() / 2));
    }

    tl::unexpected<Error> endsInHeader() const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 ends before its first row of samples, so it is likely an incomplete copy; copy it again."),
                {m_path}},
            "CAP-018");
    }

    bool isBlank(std::string_view line) const
    {
        return std::all_of(line.begin(), line.end(),
            [this](char c) { return c == ' ' || c == '\t' || c == m_file.separator; });
    }

    /// Whether a line after a blank one begins a header; otherwise it is a row under the same
    /// header (Multi_Headings No).
    bool isTagLine(std::string_view line) const
    {
        CellCursor cells(line, m_file.separator);
        std::string_view cell;
        double value = 0.0;
        return cells.next(cell) && readCell(cell, '.', value) == CellKind::Unreadable
            && readCell(cell, ',', value) == CellKind::Unreadable;
    }

    Result<void> readSegment(LineCursor &lines, std::string_view line)
    {
        if (m_header.channels.empty() || isTagLine(line)) {
            const Result<bool> header = readHeader(lines, line);
            if (!header)
                return tl::unexpected(header.error());
            if (!*header || !lines.next(line))
                return endEarly();
        }
        if (const Result<void> counted = countChannels(); !counted)
            return counted;
        LvmRows rows(m_header, m_file, m_budget);
        const Result<void> read = readRows(lines, line, rows);
        if (!read)
            return read;
        m_file.decimal = rows.decimal();
        if (rows.isEmpty())
            return endEarly();
        return addShot(std::move(rows));
    }

    /// Rows from `line` on up to a blank line.
    Result<void> readRows(LineCursor &lines, std::string_view line, LvmRows &rows)
    {
        const char *const begin = line.data();
        do {
            if (isBlank(line) || (!lines.terminated() && isCut(begin, line, lines.number())))
                break;
            if (const Result<void> row = rows.add(m_path, line, lines.number()); !row)
                return row;
            for (const char *behind = nullptr; (behind = rows.addPlain(lines.rest())) != nullptr;) {
                lines.take(behind, 1);
                if (const Result<void> going = pause(lines, begin, rows); !going)
                    return going;
            }
            if (const Result<void> going = pause(lines, begin, rows); !going)
                return going;
        } while (lines.next(line));
        return {};
    }

    /// True if there is a whole header and column line.
    Result<bool> readHeader(LineCursor &lines, std::string_view line)
    {
        LvmTags tags;
        if (!readLvmTags(lines, line, m_file.separator, tags))
            return false;
        std::string_view columnLine;
        while (lines.next(columnLine) && isBlank(columnLine)) { }
        if (isBlank(columnLine) || !lines.terminated())
            return false;
        if (const std::string other = otherThanTime(tags); !other.empty())
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1 is no recording over time: its values lie along \"%2\" (X_Dimension, X_Unit_Label), and Time in s, ms, us or ns is needed."),
                    {m_path, other}},
                "CAP-001");
        std::optional<LvmSegment> segment = lvmSegment(tags, columnLine, m_file);
        if (!segment)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1, line %2: the line of column names does not have the channels that the header declares; the file is damaged."),
                    {m_path, std::to_string(lines.number())}},
                "CAP-018");
        m_header = std::move(*segment);
        return true;
    }

    /// The file ends where a segment should be: the segments before it are whole.
    Result<void> endEarly()
    {
        if (m_set.shots.empty())
            return endsInHeader();
        if (m_saidEmpty)
            return {};
        m_saidEmpty = true;
        m_set.findings.push_back({.id = "CAP-018",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: behind segment %2 a header without rows of samples follows, so the file is likely an incomplete copy."),
                {m_path, std::to_string(m_set.shots.size())}}});
        return {};
    }

    bool isCut(const char *dataStart, std::string_view line, Index number)
    {
        TextDialect dialect;
        dialect.separator = m_file.separator;
        dialect.decimal = m_file.decimal.value_or('.');
        dialect.columns = m_header.channels.back().column + 1;
        const char *textEnd = m_text.data() + m_text.size();
        const std::string_view rows(dataStart, static_cast<std::size_t>(textEnd - dataStart));
        const RowEnd end = lastRowEnd(rows, line, dialect);
        if (end == RowEnd::Whole)
            return false;
        m_set.findings.push_back(unfinishedLine(m_path, number, RowEnd::Cut));
        return true; // LabVIEW ends every line, so doubt is enough
    }

    /// Every kRowsPerCheck rows: checks for a stop, reports, and makes room for the coming rows.
    Result<void> pause(const LineCursor &lines, const char *begin, LvmRows &rows) const
    {
        constexpr Index kRowsPerCheck = 1 << 16;
        constexpr double kSpare = 1.02;
        if (rows.size() % kRowsPerCheck != 0)
            return {};
        if (m_control.stopRequested())
            return fail(
                ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
        const auto rest = static_cast<double>(lines.rest().size());
        m_control.report(1.0 - rest / static_cast<double>(m_text.size()));
        const double perRow
            = static_cast<double>(lines.rest().data() - begin) / static_cast<double>(rows.size());
        rows.reserve(rows.size() + static_cast<Index>(kSpare * rest / perRow) + 1);
        return {};
    }

    /// Segments without a header of their own take few bytes in the file but many in memory.
    Result<void> countChannels()
    {
        m_channels += static_cast<Index>(m_header.channels.size());
        if (m_channels * kChannelBytes <= static_cast<Index>(m_text.size()))
            return {};
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 claims %2 channels in all its segments, which is more than it can hold; the file is damaged."),
                {m_path, std::to_string(m_channels)}},
            "CAP-018");
    }

    Result<void> addShot(LvmRows rows)
    {
        const auto number = static_cast<Index>(m_set.shots.size()) + 1;
        m_set.shots.push_back(
            lvmShot(m_path, number, m_header, m_file, std::move(rows), m_set.findings));
        const std::uint64_t bytes = (m_set.shots.back().channels.size() + 1) * kBytesOfChannel;
        if (m_budget.take(bytes))
            return {};
        return m_budget.exceededBy(
            m_path, Expanding::SegmentsUpTo, std::to_string(number), m_budget.taken() + bytes);
    }

    void nameShots()
    {
        const std::string stem = std::filesystem::path(m_path).stem().string();
        for (std::size_t i = 0; i < m_set.shots.size(); ++i) {
            m_set.shots[i].label = stem;
            if (m_set.shots.size() > 1)
                m_set.shots[i].label.append(", segment ").append(std::to_string(i + 1));
        }
    }

    const std::string &m_path;
    const ImportSettings &m_settings;
    const JobControl &m_control;
    std::string_view m_text;
    ExpansionBudget m_budget;
    LvmFileHeader m_file;
    LvmSegment m_header; ///< holds until the next one
    Index m_channels = 0; ///< of all shots
    bool m_saidEmpty = false;
    CaptureSet m_set;
};

} // namespace

int recogniseLvm(const std::string &, std::string_view head)
{
    return textOfBytes(std::string(head)).starts_with(kFirstWords) ? 100 : 0;
}

Result<CaptureSet> readLvm(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<FileText> text = readTextFile(path);
    if (!text)
        return tl::unexpected(text.error());
    if (!text->view().starts_with(kFirstWords))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is no LabVIEW measurement file: it does not begin with \"LabVIEW Measurement\"."),
                {path}},
            "CAP-001");
    return LvmReader(path, text->view(), settings, control).read();
}

} // namespace dyncal
