// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace dyncal {

/// Long work calls it now and then with the fraction done, 0..1, on its own thread.
using ProgressSink = std::function<void(double)>;

/// What every long stage takes last: a request to stop, and where to report how far it is.
struct JobControl
{
    std::stop_token stop;
    ProgressSink progress;

    bool stopRequested() const { return stop.stop_requested(); }
    void report(double fraction) const
    {
        if (progress)
            progress(fraction);
    }

    /// Control for the part of this work between two fractions done. It reports to this object,
    /// which must outlive it.
    JobControl between(double begin, double end) const
    {
        return {stop,
            [this, begin, end](double fraction) { report(begin + fraction * (end - begin)); }};
    }

    /// For one of `count` equal parts of this work, as between().
    JobControl part(std::size_t index, std::size_t count) const
    {
        return between(static_cast<double>(index) / static_cast<double>(count),
            static_cast<double>(index + 1) / static_cast<double>(count));
    }
};

} // namespace dyncal
