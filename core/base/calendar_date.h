// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// Whether it is a day of the calendar as ISO 8601 writes it: "2026-01-31". Blanks around it do
/// not count.
bool isCalendarDate(std::string_view text);

/// The day without blanks, which compares as text; empty where it is none.
std::string calendarDate(std::string_view text);

/// The day of a moment, "2026-01-31" of "2026-01-31T04:23:11Z"; a day is its own.
std::string dayOfMoment(std::string_view moment);

/// Days since the beginning of 1970 (UTC): of a moment as ISO 8601 writes it,
/// "2026-01-31T04:23:11Z", or of a day of the calendar, which counts at its noon. Empty where it is
/// neither.
std::optional<double> daysSince1970(std::string_view text);

} // namespace dyncal
