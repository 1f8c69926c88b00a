// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Closed interval in seconds or hertz; the name of the variable says which.
struct Interval
{
    double begin = 0.0;
    double end = 0.0;

    double length() const { return end - begin; }
    bool contains(double x) const { return x >= begin && x <= end; }
    bool operator==(const Interval &) const = default;
};

} // namespace dyncal
