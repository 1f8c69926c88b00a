// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/calendar_date.h"

#include <algorithm>
#include <charconv>
#include <chrono>

namespace dyncal {

namespace {

constexpr std::string_view kPattern = "0000-00-00";

int numberAt(std::string_view text, std::size_t begin, std::size_t count)
{
    int number = 0;
    std::from_chars(text.data() + begin, text.data() + begin + count, number);
    return number;
}

bool hasPattern(std::string_view text)
{
    if (text.size() != kPattern.size())
        return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isDigit = text[i] >= '0' && text[i] <= '9';
        if (kPattern[i] == '0' ? !isDigit : text[i] != kPattern[i])
            return false;
    }
    return true;
}

} // namespace

std::string calendarDate(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
    text.remove_prefix(begin);
    text = text.substr(0, text.find_last_not_of(kBlanks) + 1);
    if (!hasPattern(text))
        return {};
    const std::chrono::year_month_day day{std::chrono::year(numberAt(text, 0, 4)),
        std::chrono::month(static_cast<unsigned>(numberAt(text, 5, 2))),
        std::chrono::day(static_cast<unsigned>(numberAt(text, 8, 2)))};
    return day.ok() ? std::string(text) : std::string();
}

bool isCalendarDate(std::string_view text)
{
    return !calendarDate(text).empty();
}

} // namespace dyncal
