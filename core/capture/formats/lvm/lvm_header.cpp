// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm/lvm_header.h"

#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/text/time_words.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr std::size_t kLongestHeader = std::size_t(4) << 20; ///< a thousand channels need 1 MiB
constexpr std::string_view kUnsetDate = "1903/12/31"; ///< LabVIEW's zero of time

std::string_view tagCell(const LvmTags &tags, std::string_view tag, std::size_t index)
{
    const auto found = tags.find(tag);
    return found != tags.end() && index < found->second.size() ? found->second[index]
                                                               : std::string_view();
}

/// Headers of one file use either mark, whatever its data use.
std::optional<double> headerNumber(std::string_view cell)
{
    double value = 0.0;
    for (const char decimal : {'.', ','}) {
        if (readCell(cell, decimal, value) == CellKind::Number && std::isfinite(value))
            return value;
    }
    return std::nullopt;
}

std::optional<Index> headerCount(std::string_view cell)
{
    constexpr double kLargest = 1e15; // exact as a double, and more than any file holds
    const std::optional<double> value = headerNumber(cell);
    if (!value || *value < 0.0 || *value > kLargest || *value != std::floor(*value))
        return std::nullopt;
    return static_cast<Index>(*value);
}

void addNote(Attributes &notes, const std::string &key, std::string_view text)
{
    if (!text.empty())
        notes[key] = utf8Text(text);
}

/// LabVIEW writes local time without naming the zone.
void addStart(Attributes &notes, const LvmTags &tags)
{
    const std::string_view date = tagCell(tags, "Date", 0);
    if (!date.empty() && date != kUnsetDate)
        addNote(
            notes, "start_local", std::string(date).append(" ").append(tagCell(tags, "Time", 0)));
}

} // namespace

bool readLvmTags(LineCursor &lines, std::string_view line, char separator, LvmTags &tags)
{
    bool special = false;
    std::size_t bytes = 0;
    while (!line.empty() || lines.next(line)) {
        bytes += line.size() + 1;
        if (bytes > kLongestHeader && !special)
            return false;
        if (special && !line.starts_with("***End_Special***")) {
            line = {};
            continue;
        }
        std::vector<std::string_view> cells = cellsOf(line, separator);
        line = {};
        const std::string_view tag = cells[0];
        if (tag == "***End_Special***")
            special = false;
        else if (tag == "***Start_Special***")
            special = true;
        else if (tag == "***End_of_Header***")
            return true;
        else if (!tag.empty())
            tags.emplace(tag, std::vector(cells.begin() + 1, cells.end()));
    }
    return false;
}

char lvmSeparator(std::string_view text)
{
    LineCursor lines(text);
    for (std::string_view line; lines.next(line);) {
        for (const std::string_view tag : {"Separator", "Writer_Version", "***End_of_Header***"}) {
            const bool known = line.starts_with(tag) && line.size() > tag.size();
            if (known && (line[tag.size()] == '\t' || line[tag.size()] == ','))
                return line[tag.size()];
        }
        if (line.starts_with("***End_of_Header***"))
            break;
    }
    return '\t';
}

LvmFileHeader lvmFileHeader(const LvmTags &tags, char separator)
{
    LvmFileHeader file;
    file.separator = separator;
    // If the comma is both mark and separator, it splits its own cell, and the tag has two empty
    // cells.
    const auto decimal = tags.find("Decimal_Separator");
    if (decimal != tags.end() && !decimal->second.empty()) {
        if (decimal->second[0] == "." || decimal->second[0] == ",")
            file.decimal = decimal->second[0][0];
        file.commaTwice = separator == ',' && decimal->second.size() > 1
            && decimal->second[0].empty() && decimal->second[1].empty();
    }
    const std::string_view columns = tagCell(tags, "X_Columns", 0);
    if (columns == "No")
        file.xColumns = LvmXColumns::None;
    else if (columns == "Multi")
        file.xColumns = LvmXColumns::Multi;
    addNote(file.notes, "operator", tagCell(tags, "Operator", 0));
    addNote(file.notes, "project", tagCell(tags, "Project", 0));
    addNote(file.notes, "comment", tagCell(tags, "Description", 0));
    addStart(file.notes, tags);
    return file;
}

std::string otherThanTime(const LvmTags &tags)
{
    const auto first = [&](std::string_view tag, auto isTime) {
        const auto found = tags.find(tag);
        for (const std::string_view cell :
            found != tags.end() ? found->second : std::vector<std::string_view>())
            if (!cell.empty() && !isTime(utf8Text(cell)))
                return utf8Text(cell);
        return std::string();
    };
    const std::string dimension = first("X_Dimension", [](const std::string &name) {
        return isTimeTitle({name, {}});
    });
    return !dimension.empty() ? dimension : first("X_Unit_Label", [](const std::string &unit) {
        return secondsPerUnit(unit).has_value();
    });
}

std::optional<LvmSegment> lvmSegment(
    const LvmTags &tags, std::string_view columnLine, const LvmFileHeader &file)
{
    const std::vector<std::string_view> names = cellsOf(columnLine, file.separator);
    const bool multi = file.xColumns == LvmXColumns::Multi;
    const std::size_t stride = multi ? 2 : 1;
    const bool commented = names.back() == "Comment" || names.back().empty();
    const std::size_t named = names.size() - (commented && names.size() > 1 ? 2 : 1);
    const std::size_t available = multi ? named / 2 + named % 2 : named;
    const std::optional<Index> claimed = headerCount(tagCell(tags, "Channels", 0));
    if (claimed && *claimed > static_cast<Index>(available))
        return std::nullopt;
    const std::size_t count = claimed ? static_cast<std::size_t>(*claimed) : available;
    if (count == 0)
        return std::nullopt;

    LvmSegment segment;
    segment.namedChannels = static_cast<Index>(available);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t column = 1 + stride * i;
        LvmChannel channel;
        channel.column = static_cast<Index>(column);
        channel.name = utf8Text(names[column]);
        channel.unit = utf8Text(tagCell(tags, "Y_Unit_Label", column - 1));
        if (file.xColumns != LvmXColumns::None)
            channel.xColumn = multi ? channel.column - 1 : 0;
        channel.xUnit_s
            = secondsPerUnit(utf8Text(tagCell(tags, "X_Unit_Label", column - 1))).value_or(1.0);
        channel.x0 = headerNumber(tagCell(tags, "X0", column - 1)).value_or(0.0);
        const std::string_view deltaCell = tagCell(tags, "Delta_X", column - 1);
        const double delta = headerNumber(deltaCell).value_or(0.0);
        channel.deltaX = delta > 0.0 ? delta : 0.0;
        const char mark = deltaCell.find(',') != std::string_view::npos ? ',' : '.';
        channel.deltaResolution = delta > 0.0 ? printedResolution(deltaCell, mark) : 0.0;
        channel.declaredSamples = headerCount(tagCell(tags, "Samples", column - 1));
        segment.channels.push_back(std::move(channel));
    }
    segment.notes = file.notes;
    addNote(segment.notes, "comment", tagCell(tags, "Notes", 0));
    addNote(segment.notes, "test_name", tagCell(tags, "Test_Name", 0));
    addStart(segment.notes, tags);
    return segment;
}

} // namespace dyncal
