// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text_time.h"

#include "core/base/number_text.h"
#include "core/capture/formats/text_table.h"
#include "core/capture/formats/time_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

constexpr double kRateTolerance = 0.001; ///< of CAP-003
constexpr std::size_t kRowsToTellTime = 8; ///< uniform steps that are no accident

constexpr auto kTimeNames = std::to_array<std::string_view>(
    {"time", "t", "zeit", "tid", "temps", "tiempo", "tempo", "czas"});

constexpr auto kTimeUnits = std::to_array<std::pair<std::string_view, double>>(
    {{"s", 1.0}, {"sec", 1.0}, {"second", 1.0}, {"seconds", 1.0}, {"ms", 1e-3}, {"us", 1e-6},
        {"\u00B5s", 1e-6}, {"\u03BCs", 1e-6}, {"ns", 1e-9}, {"ps", 1e-12}});

std::optional<double> secondsPer(std::string_view unit)
{
    const std::string word = lowerCase(std::string(unit));
    for (const auto &[name, seconds] : kTimeUnits) {
        if (name == word)
            return seconds;
    }
    return std::nullopt;
}

/// "time_ms" is the name "time" with the unit "ms".
ColumnTitle splitSuffix(const ColumnTitle &title)
{
    const std::size_t mark = title.name.rfind('_');
    if (!title.unit.empty() || mark == std::string::npos
        || !secondsPer(title.name.substr(mark + 1)))
        return title;
    return {title.name.substr(0, mark), title.name.substr(mark + 1)};
}

bool hasTimeName(const ColumnTitle &title)
{
    const std::string name = lowerCase(splitSuffix(title).name);
    return std::find(kTimeNames.begin(), kTimeNames.end(), name) != kTimeNames.end();
}

bool isUniformTime(const std::vector<double> &values)
{
    if (values.size() < kRowsToTellTime)
        return false;
    const TimeAxis axis = timeAxisOf(values);
    const bool counter = axis.step == 1.0 && axis.first == std::floor(axis.first);
    return !axis.irregular && !counter;
}

std::optional<Index> findTimeColumn(const ImportSettings &settings,
    const std::vector<ColumnTitle> &titles, const std::vector<std::vector<double>> &columns)
{
    const auto named = settings.columns.find("time");
    if (named != settings.columns.end())
        return named->second;
    if (!settings.columns.empty() || columns.size() < 2)
        return std::nullopt;
    const auto title = std::find_if(titles.begin(), titles.end(), &hasTimeName);
    if (title != titles.end())
        return title - titles.begin();
    const bool unitOfTime = secondsPer(titles[0].unit).has_value();
    const bool otherUnit = !titles[0].unit.empty() && !unitOfTime;
    if (unitOfTime || (!otherUnit && isUniformTime(columns[0])))
        return 0;
    return std::nullopt;
}

tl::unexpected<Error> irregularTimes(const std::string &path, const std::vector<double> &times,
    const TimeAxis &axis, Index headerLines)
{
    const auto row = static_cast<std::size_t>(*axis.irregular);
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1: the times are not uniform: line %2 follows its predecessor by %3, others by %4 "
             "(allowed is 1 %). Record anew, or name only the columns of samples and give the "
             "sample rate in the recipe's import section."),
            {path, std::to_string(headerLines + *axis.irregular + 1),
                numberText(times[row] - times[row - 1], 6), numberText(axis.step, 6)}},
        "CAP-016");
}

Result<void> checkAgainst(
    const std::string &path, const ImportSettings &settings, double sampleRate_Hz)
{
    if (!settings.sampleRate_Hz
        || std::abs(*settings.sampleRate_Hz / sampleRate_Hz - 1.0) <= kRateTolerance)
        return {};
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1: the recipe states a sample rate of %2, but the column of times steps at %3. "
             "Which one is right? Take sample_rate_hz out of the recipe, or name only the columns "
             "of samples there."),
            {path, numberWithUnit(*settings.sampleRate_Hz, "Hz", 7),
                numberWithUnit(sampleRate_Hz, "Hz", 7)}},
        "CAP-003");
}

tl::unexpected<Error> unknownTimeUnit(const std::string &path, const std::string &unit)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1: the unit \"%2\" of the column of times is unknown; write s, ms, us or ns."),
            {path, unit}},
        "CAP-016");
}

} // namespace

Result<TextTime> timeOfTable(const std::string &path, const ImportSettings &settings,
    const std::vector<ColumnTitle> &titles, const std::vector<std::vector<double>> &columns,
    Index headerLines)
{
    TextTime time;
    time.column = findTimeColumn(settings, titles, columns);
    if (!time.column)
        return time;
    const auto column = static_cast<std::size_t>(*time.column);
    const std::string unit = splitSuffix(titles[column]).unit;
    const std::optional<double> scale_s = unit.empty() ? 1.0 : secondsPer(unit);
    if (!scale_s)
        return unknownTimeUnit(path, unit);
    const std::vector<double> &times = columns[column];
    if (times.size() < 2)
        return time;
    const TimeAxis axis = timeAxisOf(times);
    if (axis.irregular)
        return irregularTimes(path, times, axis, headerLines);
    time.sampleRate_Hz = 1.0 / (axis.step * *scale_s);
    time.first_s = axis.first * *scale_s;
    if (const Result<void> checked = checkAgainst(path, settings, time.sampleRate_Hz); !checked)
        return tl::unexpected(checked.error());
    return time;
}

} // namespace dyncal
