// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/reported_value.h"

#include <algorithm>
#include <string>

namespace dyncal::testing {

/// The line of a reported value's budget with this name; null where it has none.
inline const UncertaintyLine *lineOf(const ReportedValue &value, const std::string &quantity)
{
    const auto found = std::ranges::find(value.lines, quantity, &UncertaintyLine::quantity);
    return found == value.lines.end() ? nullptr : &*found;
}

} // namespace dyncal::testing
