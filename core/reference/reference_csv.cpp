// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_csv.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

struct Column
{
    const char *name;
    double ReferencePoint::*value;
};

constexpr std::array<Column, 6> kColumns{
    {{"frequency_hz", &ReferencePoint::frequency_Hz}, {"magnitude", &ReferencePoint::magnitude},
        {"u_magnitude", &ReferencePoint::u_magnitude}, {"phase_rad", &ReferencePoint::phase_rad},
        {"u_phase_rad", &ReferencePoint::u_phase_rad}, {"dof", &ReferencePoint::dof}}};
constexpr std::size_t kNeeded = 3; ///< of the columns above

struct Line
{
    Index number = 0;
    std::string_view text;
};

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == text.npos ? std::string_view()
                              : text.substr(first, text.find_last_not_of(kBlank) + 1 - first);
}

std::vector<std::string_view> split(std::string_view text, char mark)
{
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(mark, at), text.size());
        parts.push_back(trimmed(text.substr(at, end - at)));
        at = end + 1;
    }
    return parts;
}

/// Those that hold anything.
std::vector<Line> linesOf(std::string_view text)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    std::vector<Line> lines;
    Index number = 0;
    for (const std::string_view line : split(text, '\n')) {
        ++number;
        if (!line.empty() && line.front() != '#')
            lines.push_back({number, line});
    }
    return lines;
}

/// Where each of kColumns stands; npos where it is not given.
using Places = std::array<std::size_t, kColumns.size()>;

tl::unexpected<Error> partedBySemicolons()
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The first line of the table has semicolons; the columns are parted by commas, and the numbers have a decimal point and no decimal comma."),
            {}});
}

tl::unexpected<Error> namedTwice(std::string_view name)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The table names the column '%1' twice, so that its values are not known; leave one of the two out."),
            {std::string(name)}});
}

Result<Places> placesOf(const std::vector<std::string_view> &names)
{
    Places places;
    places.fill(std::string_view::npos);
    if (!names.empty() && names[0].find(';') != std::string_view::npos)
        return partedBySemicolons();
    for (std::size_t at = 0; at < names.size(); ++at) {
        const auto known = std::ranges::find(kColumns, names[at], &Column::name);
        if (known == kColumns.end())
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "The table has a column '%1'; it may have frequency_hz, magnitude, u_magnitude, phase_rad, u_phase_rad and dof."),
                    {std::string(names[at])}});
        std::size_t &place = places[static_cast<std::size_t>(known - kColumns.begin())];
        if (place != std::string_view::npos)
            return namedTwice(names[at]);
        place = at;
    }
    for (std::size_t i = 0; i < kNeeded; ++i)
        if (places[i] == std::string_view::npos)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT(
                     "core", "The table has no column '%1'; its first line must name the columns."),
                    {kColumns[i].name}});
    return places;
}

/// A value too many, as of a decimal comma, would move all behind it into the next column.
Result<void> checkCount(const Line &line, std::size_t found, std::size_t names)
{
    if (found == names)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "Line %1 of the table has %2 values for %3 columns; they are parted by commas, and the numbers have a decimal point and no decimal comma."),
            {std::to_string(line.number), std::to_string(found), std::to_string(names)}});
}

/// `names`: how many the first line has.
Result<ReferencePoint> pointOf(const Line &line, const Places &places, std::size_t names)
{
    const std::vector<std::string_view> cells = split(line.text, ',');
    if (const Result<void> counted = checkCount(line, cells.size(), names); !counted)
        return tl::unexpected(counted.error());
    ReferencePoint point;
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        if (places[i] == std::string_view::npos)
            continue;
        const std::string_view cell = cells[places[i]];
        if (cell.empty() && kColumns[i].value == &ReferencePoint::dof)
            continue;
        const std::optional<double> value = parseNumber(cell);
        if (!value)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "Line %1 of the table has '%2' for %3, which is no number with a decimal point."),
                    {std::to_string(line.number), std::string(cell), kColumns[i].name}});
        point.*kColumns[i].value = *value;
    }
    return point;
}

} // namespace

Result<ReferenceSensitivity> readReferenceCsv(std::string_view text)
{
    const std::vector<Line> lines = linesOf(text);
    const std::vector<std::string_view> names
        = lines.empty() ? std::vector<std::string_view>() : split(lines[0].text, ',');
    const Result<Places> places = placesOf(names);
    if (!places)
        return tl::unexpected(places.error());
    std::vector<ReferencePoint> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const Result<ReferencePoint> point = pointOf(lines[i], *places, names.size());
        if (!point)
            return tl::unexpected(point.error());
        rows.push_back(*point);
    }
    return ReferenceSensitivity::fromTable(std::move(rows));
}

} // namespace dyncal
