// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/bytes/counted_header.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr Index kFewest = 8; ///< samples; fewer prove nothing
constexpr double kMostCounted = 1e12;
constexpr double kLongestInterval_s = 0.01;

bool isCount(double value, double from, double to)
{
    return value >= from && value <= to && value == std::floor(value);
}

} // namespace

std::optional<CountedHeader> countedHeader(std::span<const double> column)
{
    if (column.size() < 2 || !isCount(column[0], kFewest, kMostCounted) || !(column[1] > 0.0)
        || column[1] > kLongestInterval_s)
        return std::nullopt;
    CountedHeader header{0, static_cast<Index>(column[0]), column[1], true};
    const auto rows = static_cast<Index>(column.size());
    const bool trigger = rows > 2 && isCount(column[2], 0.0, column[0]);
    const bool fraction = rows > 3 && trigger && column[3] >= 0.0 && column[3] <= 1.0;
    header.lines = rows - header.declared;
    const Index plausible = fraction ? 4 : trigger ? 3 : 2; // a cut file may fit a shorter header
    if (header.lines == plausible || (header.lines == 2 && !fraction))
        return header;
    const bool lessThanAll = rows < header.declared + 2;
    header.lines = fraction ? 4 : 2;
    header.complete = false;
    return fraction || lessThanAll ? std::optional(header) : std::nullopt;
}

} // namespace dyncal
