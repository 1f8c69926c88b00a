// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace dyncal {
namespace {

constexpr std::time_t kLatest = 253402300799; // the last second of the year 9999

Result<std::string> utcText(std::time_t seconds)
{
    std::tm parts = {};
    char text[32];
    if (!gmtime_r(&seconds, &parts)
        || std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts) == 0)
        return fail(ErrorKind::Internal, {DYNCAL_TEXT("core", "The clock cannot be read."), {}});
    return std::string(text);
}

} // namespace

Result<std::string> currentUtc()
{
    const char *fixed = std::getenv("SOURCE_DATE_EPOCH");
    if (!fixed)
        return utcText(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
    std::time_t seconds = 0;
    const char *end = fixed + std::strlen(fixed);
    const auto parsed = std::from_chars(fixed, end, seconds);
    if (parsed.ec != std::errc() || parsed.ptr != end || seconds < 0 || seconds > kLatest)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "SOURCE_DATE_EPOCH is \"%1\"; it needs a whole number of seconds since 1970."),
                {fixed}});
    return utcText(seconds);
}

} // namespace dyncal
