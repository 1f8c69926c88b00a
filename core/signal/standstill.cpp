// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/standstill.h"

#include "core/base/number_text.h"
#include "core/signal/automatic_length.h"
#include "core/signal/stuck_values.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dyncal {
namespace {

constexpr double kMostStuck = 0.2; ///< of the samples looked at
constexpr double kLateNotice = 1.05; ///< a departure from the plateau is noticed late by blocks

/// The window and as many samples behind it, up to the first that is not finite.
Eigen::VectorXd lookedAt(const Channel &channel, const SampleRange &window)
{
    const Index size = std::min(2 * window.size(), channel.samples.size() - window.begin);
    Eigen::VectorXd values = physicalValues(channel, window.begin, size);
    const auto isInvalid = [](double value) { return !std::isfinite(value); };
    const Index finite
        = std::find_if(values.begin() + window.size(), values.end(), isInvalid) - values.begin();
    return values.head(finite);
}

/// Whether the values froze inside the range of the later half of a window of `size` samples, near
/// its end as far as the search for the plateau's end can tell.
bool frozeAtEnd(const Eigen::VectorXd &values, const StuckValues &stuck, Index size)
{
    const auto later = values.segment(size / 2, size - size / 2);
    const double value = values[stuck.begin];
    const double latest = kLateNotice * static_cast<double>(size) / kUsedShare;
    return value > later.minCoeff() && value < later.maxCoeff()
        && static_cast<double>(stuck.begin) <= latest;
}

std::string valueText(const Channel &channel, const Standstill &found)
{
    return numberWithUnit(found.value, channel.unit);
}

std::string beginText(const Channel &channel, const Standstill &found)
{
    return numberWithUnit(channel.timeOf_s(found.begin), "s", 6);
}

} // namespace

std::optional<Standstill> standstill(const Channel &channel, const WindowBands &bands)
{
    const SampleRange &window = bands.window;
    const Eigen::VectorXd values = lookedAt(channel, window);
    const Eigen::VectorXd quiet
        = physicalValues(channel, bands.baseline.begin, bands.baseline.size());
    const auto size = static_cast<double>(window.size());
    const auto found = [&](const StuckValues &stuck, double windowShare) {
        return Standstill{window.begin + stuck.begin, stuck.longest, values[stuck.begin],
            windowShare, frozeAtEnd(values, stuck, window.size())};
    };
    const std::optional<StuckValues> inside = stuckValues(values.head(window.size()), quiet);
    const double share = inside ? static_cast<double>(inside->total) / size : 0.0;
    if (share > kMostStuck)
        return found(*inside, share);
    const std::optional<StuckValues> all = stuckValues(values, quiet);
    if (!all || static_cast<double>(all->total) <= kMostStuck * static_cast<double>(values.size()))
        return std::nullopt;
    return found(*all, share);
}

std::optional<Error> blockingStandstill(
    const Channel &channel, Index shot, const Standstill &found, bool endIsSearched)
{
    const std::string number = std::to_string(shot);
    if (found.windowShare > kMostStuck)
        return Error{ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1, channel %2 stands still at %3 for %4 % of the response window, the longest time from %5 on, although its baseline shows noise: it was cut off or stuck. The shot cannot be used: exclude it."),
                {number, channel.name, valueText(channel, found),
                    numberText(100.0 * found.windowShare, 2), beginText(channel, found)}},
            "CAP-007", shot};
    if (!endIsSearched || !found.setsTheEnd)
        return std::nullopt;
    return Error{ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "Shot %1, channel %2 stands still at %3 from %4 on, although its baseline shows noise: it froze during the response, so the end of the plateau cannot be found. Exclude the shot, or set window.end_s before that time if the record up to there can be trusted."),
            {number, channel.name, valueText(channel, found), beginText(channel, found)}},
        "CAP-007", shot};
}

Finding standstillBehind(const Channel &channel, Index shot, const Standstill &found)
{
    const double length_s = static_cast<double>(found.longest) / channel.sampleRate_Hz;
    Finding result{.id = "CAP-007",
        .severity = Severity::Caution,
        .shot = shot,
        .channel = channel.name,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1, channel %2 stands still at %3 for %4 from %5 on, soon behind the response window, although its baseline shows noise: it was cut off or stuck there; look whether the response before can be trusted."),
            {std::to_string(shot), channel.name, valueText(channel, found),
                numberWithUnit(length_s, "s", 3), beginText(channel, found)}}};
    result.time_s = channel.timeOf_s(found.begin);
    return result;
}

} // namespace dyncal
