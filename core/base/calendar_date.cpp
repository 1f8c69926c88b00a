// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/calendar_date.h"

#include <algorithm>
#include <charconv>
#include <chrono>

namespace dyncal {

namespace {

constexpr std::string_view kDayPattern = "0000-00-00";
constexpr std::string_view kMomentPattern = "0000-00-00T00:00:00Z";

int numberAt(std::string_view text, std::size_t begin, std::size_t count)
{
    int number = 0;
    std::from_chars(text.data() + begin, text.data() + begin + count, number);
    return number;
}

/// '0' stands for any digit, anything else for itself.
bool hasPattern(std::string_view text, std::string_view pattern)
{
    if (text.size() != pattern.size())
        return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isDigit = text[i] >= '0' && text[i] <= '9';
        if (pattern[i] == '0' ? !isDigit : text[i] != pattern[i])
            return false;
    }
    return true;
}

std::chrono::year_month_day dayIn(std::string_view text)
{
    return {std::chrono::year(numberAt(text, 0, 4)),
        std::chrono::month(static_cast<unsigned>(numberAt(text, 5, 2))),
        std::chrono::day(static_cast<unsigned>(numberAt(text, 8, 2)))};
}

/// Of the day; a leap second is none.
std::optional<double> secondsIn(std::string_view moment)
{
    const int hour = numberAt(moment, 11, 2), minute = numberAt(moment, 14, 2),
              second = numberAt(moment, 17, 2);
    if (hour > 23 || minute > 59 || second > 59)
        return std::nullopt;
    return 3600.0 * hour + 60.0 * minute + second;
}

} // namespace

std::string calendarDate(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
    text.remove_prefix(begin);
    text = text.substr(0, text.find_last_not_of(kBlanks) + 1);
    if (!hasPattern(text, kDayPattern))
        return {};
    return dayIn(text).ok() ? std::string(text) : std::string();
}

bool isCalendarDate(std::string_view text)
{
    return !calendarDate(text).empty();
}

std::string dayOfMoment(std::string_view moment)
{
    constexpr std::size_t kDay = 10; // "2026-01-31"
    return std::string(moment.substr(0, kDay));
}

std::optional<double> daysSince1970(std::string_view text)
{
    constexpr double kNoon_s = 43200.0, kDay_s = 86400.0;
    const std::string_view day = text.substr(0, kDayPattern.size());
    std::optional<double> seconds;
    if (text.size() == day.size())
        seconds = kNoon_s;
    else if (hasPattern(text, kMomentPattern))
        seconds = secondsIn(text);
    if (!seconds || !hasPattern(day, kDayPattern) || !dayIn(day).ok())
        return std::nullopt;
    return static_cast<double>(std::chrono::sys_days(dayIn(day)).time_since_epoch().count())
        + *seconds / kDay_s;
}

} // namespace dyncal
