// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm.h"

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/capture/formats/lvm_header.h"
#include "core/capture/formats/lvm_rate.h"
#include "core/capture/formats/table_end.h"
#include "core/capture/formats/time_axis.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <span>

namespace dyncal {
namespace {

constexpr std::string_view kFirstWords = "LabVIEW Measurement";
constexpr std::size_t kComments = 10; ///< different ones kept of a comment column

/// Rows of one segment as they are collected.
struct SegmentData
{
    LvmSegment header;
    std::vector<SampleColumn> values; ///< one per channel
    std::vector<std::vector<double>> x; ///< one per X column
    double xResolution = 0.0; ///< of the X cell printed with the fewest decimals
    std::vector<std::string> comments;
};

class LvmReader
{
public:
    LvmReader(const std::string &path, const ImportSettings &settings, const JobControl &control)
        : m_path(path)
        , m_settings(settings)
        , m_control(control)
    {
    }

    Result<CaptureSet> read(std::string_view text)
    {
        m_text = text;
        LineCursor lines(text);
        LvmTags tags;
        const char separator = lvmSeparator(text);
        if (!readLvmTags(lines, {}, separator, tags))
            return endsInHeader();
        m_file = lvmFileHeader(tags, separator);
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
    tl::unexpected<Error> endsInHeader() const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 ends before its first row of samples, so it is likely an incomplete copy; "
                 "copy it again."),
                {m_path}},
            "CAP-018");
    }

    bool isBlank(std::string_view line) const
    {
        return std::all_of(line.begin(), line.end(),
            [this](char c) { return c == ' ' || c == '\t' || c == m_file.separator; });
    }

    /// Whether a line behind a blank one begins a header; the other choice is further rows under
    /// the same header (Multi_Headings No).
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
        SegmentData data;
        data.header = m_header;
        data.values.resize(m_header.channels.size());
        data.x.resize(xColumnCount());
        const char *dataStart = line.data();
        do {
            if (isBlank(line))
                break;
            if (!lines.terminated() && isCut(dataStart, line, lines.number()))
                break;
            if (const Result<void> row = addRow(data, line, lines.number()); !row)
                return row;
        } while (lines.next(line));
        const bool empty = std::all_of(data.values.begin(), data.values.end(),
            [](const SampleColumn &column) { return column.size() == 0; });
        if (empty)
            return endEarly();
        addShot(std::move(data));
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
        std::optional<LvmSegment> segment = lvmSegment(tags, columnLine, m_file);
        if (!segment)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1, line %2: the line of column names does not have the channels that the "
                     "header declares; the file is damaged."),
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
        m_set.findings.push_back({"CAP-018", Severity::Caution, 0, {}, {},
            {DYNCAL_TEXT("core",
                 "%1: behind segment %2 a header without rows of samples follows, so the file is "
                 "likely an incomplete copy."),
                {m_path, std::to_string(m_set.shots.size())}},
            {}, {}});
        return {};
    }

    std::size_t xColumnCount() const
    {
        if (m_file.xColumns == LvmXColumns::None)
            return 0;
        return m_file.xColumns == LvmXColumns::One ? 1 : m_header.channels.size();
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

    Result<void> addRow(SegmentData &data, std::string_view line, Index number)
    {
        constexpr Index kRowsPerCheck = 1 << 16;
        if (number % kRowsPerCheck == 0) {
            if (m_control.stopRequested())
                return fail(ErrorKind::Cancelled,
                    {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
            m_control.report(static_cast<double>(line.data() - m_text.data())
                / static_cast<double>(m_text.size()));
        }
        const Index stride = m_file.xColumns == LvmXColumns::Multi ? 2 : 1;
        const Index columns = data.header.channels.back().column + 1;
        CellCursor cursor(line, m_file.separator);
        Index column = 0;
        for (std::string_view cell; column < columns; ++column) {
            if (!cursor.next(cell))
                cell = {};
            const bool isX = stride == 2 ? column % 2 == 0 : column == 0;
            if (isX)
                addX(data, column / 2, cell);
            else if (!addValue(data.values[static_cast<std::size_t>((column - 1) / stride)], cell))
                return unreadableCell(m_path, number, column + 1, cell);
        }
        std::string_view comment;
        if (cursor.next(comment) && !comment.empty())
            addComment(data, comment);
        return {};
    }

    bool addValue(SampleColumn &values, std::string_view cell)
    {
        if (!m_file.decimal && cell.find_first_of(".,") != std::string_view::npos)
            m_file.decimal = cell.find(',') != std::string_view::npos ? ',' : '.';
        double value = 0.0;
        const CellKind kind = readCell(cell, m_file.decimal.value_or('.'), value);
        if (kind == CellKind::Number)
            values.addValue(value);
        else if (kind == CellKind::Empty)
            values.addEmpty();
        return kind != CellKind::Unreadable;
    }

    void addX(SegmentData &data, Index index, std::string_view cell)
    {
        if (data.x.empty())
            return;
        double value = 0.0;
        char decimal = m_file.decimal.value_or('.');
        if (!m_file.decimal && cell.find(',') != std::string_view::npos)
            decimal = ',';
        const CellKind kind = readCell(cell, decimal, value);
        if (kind == CellKind::Number)
            data.xResolution = std::max(data.xResolution, printedResolution(cell, decimal));
        data.x[static_cast<std::size_t>(index)].push_back(
            kind == CellKind::Number ? value : std::numeric_limits<double>::quiet_NaN());
    }

    static void addComment(SegmentData &data, std::string_view comment)
    {
        std::string text = utf8Text(comment);
        const auto known = std::find(data.comments.begin(), data.comments.end(), text);
        if (known == data.comments.end() && data.comments.size() < kComments)
            data.comments.push_back(std::move(text));
    }

    void addShot(SegmentData data)
    {
        const auto number = static_cast<Index>(m_set.shots.size()) + 1;
        Shot shot;
        shot.notes = data.header.notes;
        for (const std::string &comment : data.comments) {
            std::string &note = shot.notes["comment"];
            note.append(note.empty() ? "" : "; ").append(comment);
        }
        compareCounts(data, number);
        for (std::size_t i = 0; i < data.values.size(); ++i) {
            const LvmChannel &header = data.header.channels[i];
            Channel channel;
            channel.name
                = header.name.empty() ? "column " + std::to_string(header.column + 1) : header.name;
            channel.unit = header.unit.empty() ? "1" : header.unit;
            channel.sampleRate_Hz = sampleRateOf(data, i, number);
            channel.t0_s = header.x0;
            channel.samples = RawSamples(data.values[i].take());
            channel.sha256 = sha256OfSamples(channel.samples);
            shot.channels.push_back(std::move(channel));
        }
        m_set.shots.push_back(std::move(shot));
    }

    double sampleRateOf(const SegmentData &data, std::size_t index, Index shot)
    {
        const LvmChannel &channel = data.header.channels[index];
        const bool multi = m_file.xColumns == LvmXColumns::Multi;
        // One X column for all belongs to the first channel and those of the same Delta_X.
        const bool ownX
            = channel.xColumn && (multi || channel.deltaX == data.header.channels.front().deltaX);
        const auto count = static_cast<std::size_t>(data.values[index].size());
        std::span<const double> x;
        if (ownX)
            x = std::span(data.x[multi ? index : 0]).first(count);
        const LvmRate rate = lvmRate(channel, x, data.xResolution);
        if (rate.contradicted)
            m_set.findings.push_back(contradiction(channel, rate.meanStep, shot));
        return rate.sampleRate_Hz;
    }

    Finding contradiction(const LvmChannel &channel, double mean, Index shot) const
    {
        return {"CAP-016", Severity::Caution, shot, channel.name, {},
            {DYNCAL_TEXT("core",
                 "%1: Delta_X of channel %2 is %3, but its X values are not uniform or step by %4 "
                 "on average; state the sample rate in the recipe's import section if it is "
                 "known."),
                {m_path, channel.name, numberText(channel.deltaX, 7), numberText(mean, 7)}},
            mean, channel.deltaX};
    }

    /// LabVIEW appends to segments, so more than declared is normal.
    void compareCounts(const SegmentData &data, Index shot)
    {
        for (std::size_t i = 0; i < data.values.size(); ++i) {
            const LvmChannel &channel = data.header.channels[i];
            const Index found = data.values[i].size();
            const Index declared = channel.declaredSamples.value_or(found);
            if (found == declared)
                continue;
            m_set.findings.push_back({"CAP-018",
                found < declared ? Severity::Caution : Severity::Info, shot, channel.name, {},
                {DYNCAL_TEXT("core",
                     "%1: channel %2 has %3 samples where its header declares %4; if it has fewer, "
                     "the file may be an incomplete copy."),
                    {m_path, channel.name, std::to_string(found), std::to_string(declared)}},
                static_cast<double>(found), static_cast<double>(declared)});
            return;
        }
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
    LvmFileHeader m_file;
    LvmSegment m_header; ///< holds until the next one
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
                 "%1 is no LabVIEW measurement file: it does not begin with \"LabVIEW "
                 "Measurement\"."),
                {path}},
            "CAP-001");
    return LvmReader(path, settings, control).read(text->view());
}

} // namespace dyncal
