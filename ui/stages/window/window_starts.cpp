// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/window/window_starts.h"

#include "ui/stages/window/marked_stretch.h"

#include <cmath>

namespace dyncal {

namespace {

/// Keeps the marked stretches where they are in the records: they are counted from the start, which
/// is a sample.
void follow(
    WindowSettings &settings, const std::vector<double> &starts_s, const WindowResult &window)
{
    std::vector<double> later_s(starts_s.size(), 0.0);
    for (const WindowedResponse &response : window.responses) {
        const auto at = static_cast<std::size_t>(response.shot - 1);
        if (at < starts_s.size())
            later_s[at] = std::round((starts_s[at] - response.start_s) * response.sampleRate_Hz)
                / response.sampleRate_Hz;
    }
    keepInRecord(settings.excludeStretches, later_s);
}

} // namespace

std::vector<double> usedStarts(const WindowResult &window, std::size_t shots)
{
    std::vector<double> starts_s(shots, window.responses.front().start_s);
    for (const WindowedResponse &response : window.responses)
        if (response.shot >= 1 && response.shot <= static_cast<Index>(shots))
            starts_s[static_cast<std::size_t>(response.shot - 1)] = response.start_s;
    return starts_s;
}

void typeStarts(
    WindowSettings &settings, const std::vector<double> &starts_s, const WindowResult &window)
{
    settings.start_s = starts_s;
    follow(settings, starts_s, window);
}

void detectStartsAgain(WindowSettings &settings, const CalibrationResults &results)
{
    settings.start_s.clear();
    if (!results.window || results.window->responses.empty() || !results.starts
        || !results.captures)
        return;
    const CaptureSet &set = results.captures->set;
    std::vector<double> starts_s = usedStarts(*results.window, set.shots.size());
    for (std::size_t i = 0; i < starts_s.size(); ++i) {
        const Channel *dut = set.shots[i].channelWithRole(ChannelRole::Dut);
        if (const DetectedStart *found = results.starts->of(set, static_cast<Index>(i) + 1, dut))
            starts_s[i] = found->time_s;
    }
    follow(settings, starts_s, *results.window);
}

} // namespace dyncal
