// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/tube_mode_poles.h"

#include "core/base/interval.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

namespace dyncal {
namespace {

constexpr double kNear = 0.03; ///< as between a peak and a computed mode

/// Frequencies of one mode over the shots, and how it is called.
struct Mode
{
    Interval span_Hz;
    std::string name;
    bool movesWithGas = false; ///< observed, not only computed
};

void extend(Interval &span_Hz, double frequency_Hz)
{
    span_Hz.begin = std::min(span_Hz.begin, frequency_Hz);
    span_Hz.end = std::max(span_Hz.end, frequency_Hz);
}

std::vector<Mode> seenModes(const std::vector<FollowedPeak> &peaks)
{
    std::vector<Mode> modes;
    for (const FollowedPeak &peak : peaks) {
        if (!peak.test.followsGas || peak.peaks.empty())
            continue;
        Mode mode{{peak.peaks.front().frequency_Hz, peak.peaks.front().frequency_Hz}, {}, true};
        for (const PeakOfShot &shot : peak.peaks) {
            extend(mode.span_Hz, shot.frequency_Hz);
            mode.name += std::string(mode.name.empty() ? "" : "/")
                + numberWithUnit(shot.frequency_Hz, "Hz", 3);
        }
        modes.push_back(std::move(mode));
    }
    return modes;
}

std::vector<Mode> computedModes(const ShockConditionsSet &conditions)
{
    std::map<std::string, Mode> byName;
    for (const ShockConditions &shot : conditions.shots) {
        for (const TubeResonance &resonance : shot.resonances) {
            const Interval own{resonance.frequency_Hz, resonance.frequency_Hz};
            const auto [at, isNew] = byName.try_emplace(resonance.label(), Mode{own, {}, false});
            extend(at->second.span_Hz, resonance.frequency_Hz);
        }
    }
    std::vector<Mode> modes;
    for (auto &[name, mode] : byName) {
        mode.name = name;
        modes.push_back(mode);
    }
    return modes;
}

const Mode *modeAt(const std::vector<Mode> &modes, double frequency_Hz)
{
    const auto found = std::ranges::find_if(modes, [&](const Mode &mode) {
        return frequency_Hz > mode.span_Hz.begin * (1.0 - kNear)
            && frequency_Hz < mode.span_Hz.end * (1.0 + kNear);
    });
    return found == modes.end() ? nullptr : &*found;
}

/// What a sentence names: "6.12 kHz (6.1 kHz/6.38 kHz/6.79 kHz)", or the computed mode.
using Named = std::vector<std::string>;

std::string listed(const Named &named)
{
    std::string list;
    for (const std::string &name : named)
        list += std::string(list.empty() ? "" : ", ") + name;
    return list;
}

Finding seenFinding(const Named &named)
{
    return {.id = "MOD-012",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The model holds poles of the tube's gas: %1 (in brackets the peak that moves with the sound speed, shot by shot). Leave that oscillation out of the model, or it is certified as the sensor's."),
            {listed(named)}},
        .value = static_cast<double>(named.size()),
        .limit = 0.0};
}

Finding computedFinding(const Named &named)
{
    return {.id = "MOD-012",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core",
               "Poles within 3 % of a computed resonance of the tube: %1. If they are not the sensor's, leave that oscillation out of the model."),
            {listed(named)}},
        .value = static_cast<double>(named.size()),
        .limit = 0.0};
}

} // namespace

void judgeTubeModes(const std::vector<FollowedPeak> &peaks, const ShockConditionsSet &conditions,
    SensorModel &model)
{
    const std::vector<Mode> seen = seenModes(peaks);
    const std::vector<Mode> computed = computedModes(conditions);
    Named inSeen;
    Named inComputed;
    for (Pole &pole : model.poles) {
        const Mode *mode = pole.z.imag() != 0.0 ? modeAt(seen, pole.frequency_Hz) : nullptr;
        if (!mode && pole.z.imag() != 0.0)
            mode = modeAt(computed, pole.frequency_Hz);
        if (!mode)
            continue;
        pole.flags.push_back(kTubeModeFlag);
        if (pole.poleClass == PoleClass::Sensor && pole.z.imag() > 0.0)
            (mode->movesWithGas ? inSeen : inComputed)
                .push_back(numberWithUnit(pole.frequency_Hz, "Hz", 4) + " (" + mode->name + ")");
    }
    if (!inSeen.empty())
        model.findings.push_back(seenFinding(inSeen));
    if (!inComputed.empty())
        model.findings.push_back(computedFinding(inComputed));
}

} // namespace dyncal
