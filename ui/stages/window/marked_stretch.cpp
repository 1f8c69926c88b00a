// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/window/marked_stretch.h"

#include <algorithm>

namespace dyncal {

namespace {

/// The latest end among the windows of these shots; 0 if none is used.
double lastEnd_s(const std::vector<Index> &shots, const std::vector<WindowedResponse> &responses)
{
    double last_s = 0.0;
    for (const WindowedResponse &response : responses)
        if (std::ranges::find(shots, response.shot) != shots.end())
            last_s
                = std::max(last_s, static_cast<double>(response.length) / response.sampleRate_Hz);
    return last_s;
}

} // namespace

std::vector<MarkedStretch> markedStretches(const std::vector<ExcludedStretch> &entries)
{
    std::vector<MarkedStretch> marked;
    for (const ExcludedStretch &entry : entries) {
        const Interval span_s{entry.from_s, entry.to_s};
        const auto known = std::ranges::find_if(marked, [&](const MarkedStretch &other) {
            return other.span_s == span_s && other.reason == entry.reason
                && std::ranges::find(other.shots, entry.shot) == other.shots.end();
        });
        if (known == marked.end()) {
            marked.push_back({span_s, {entry.shot}, entry.reason});
            continue;
        }
        known->shots.push_back(entry.shot);
        std::ranges::sort(known->shots);
    }
    return marked;
}

std::vector<ExcludedStretch> excludedStretches(const std::vector<MarkedStretch> &stretches)
{
    std::vector<ExcludedStretch> entries;
    for (const MarkedStretch &stretch : stretches)
        for (const Index shot : stretch.shots)
            entries.push_back({shot, stretch.span_s.begin, stretch.span_s.end, stretch.reason});
    return entries;
}

void keepInRecord(std::vector<ExcludedStretch> &entries, const std::vector<double> &later_s)
{
    for (ExcludedStretch &entry : entries) {
        const auto at = static_cast<std::size_t>(entry.shot - 1);
        if (at >= later_s.size())
            continue;
        entry.from_s -= later_s[at];
        entry.to_s -= later_s[at];
    }
}

StretchFault faultOf(const MarkedStretch &stretch, const std::vector<WindowedResponse> &responses)
{
    if (!(stretch.span_s.begin < stretch.span_s.end))
        return StretchFault::EndBeforeBegin;
    for (const WindowedResponse &response : responses) {
        if (std::ranges::find(stretch.shots, response.shot) == stretch.shots.end())
            continue;
        const double end_s = static_cast<double>(response.length) / response.sampleRate_Hz;
        if (!(stretch.span_s.begin < end_s && stretch.span_s.end > 0.0))
            return StretchFault::OutsideWindow;
    }
    return stretch.reason.empty() ? StretchFault::NoReason : StretchFault::None;
}

Interval withinWindows(Interval span_s, const std::vector<Index> &shots,
    const std::vector<WindowedResponse> &responses)
{
    const double end_s = lastEnd_s(shots, responses);
    if (!(span_s.begin < end_s && span_s.end > 0.0))
        return span_s;
    return {std::max(span_s.begin, 0.0), std::min(span_s.end, end_s)};
}

} // namespace dyncal
