// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/shot_generator.h"
#include "tests/core/synthesis/simulated_shots.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace dyncal::testing {

/// Small settings with defects as they are typed.
inline SimulationSettings withDefects(
    const std::vector<std::string> &texts, const char *preset = "piezo")
{
    SimulationSettings settings = smallSettings(preset);
    for (const std::string &text : texts)
        settings.defects.push_back(parseDefect(text).value());
    return settings;
}

/// The same without noise and with fine codes: the record is what was computed.
inline SimulationSettings quietWithDefects(
    const std::vector<std::string> &texts, const char *preset = "piezo")
{
    SimulationSettings settings = withDefects(texts, preset);
    settings.noise = 0.0;
    settings.bits = 28;
    return settings;
}

inline const Channel &channelOf(const SimulatedCapture &capture, std::size_t shot, std::size_t c)
{
    return capture.set.shots.at(shot).channels.at(c);
}

inline double meanOf(const Channel &channel, double begin_s, double end_s)
{
    const auto sampleAt = [&](double time_s) {
        return static_cast<Index>((time_s - channel.t0_s) * channel.sampleRate_Hz);
    };
    return physicalValues(channel, sampleAt(begin_s), sampleAt(end_s) - sampleAt(begin_s)).mean();
}

/// Largest deviation of a channel from what is expected at the times of its axis, until `end_s`.
template <typename Expected>
double worstDeviation(const Channel &channel, double end_s, const Expected &expected)
{
    double worst = 0.0;
    for (Index i = 0; i < channel.samples.size() && channel.timeOf_s(i) < end_s; ++i)
        worst = std::max(worst,
            std::abs(
                physicalValue(channel, channel.samples.at(i)) - expected(channel.timeOf_s(i))));
    return worst;
}

/// Whether all channels of all shots hold the same counts.
inline bool haveSameCounts(const SimulatedCapture &a, const SimulatedCapture &b)
{
    for (std::size_t s = 0; s < a.set.shots.size(); ++s) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (channelOf(a, s, c).sha256 != channelOf(b, s, c).sha256)
                return false;
        }
    }
    return a.set.shots.size() == b.set.shots.size();
}

} // namespace dyncal::testing
