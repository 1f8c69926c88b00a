// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/stated_poles.h"

#include <cmath>

namespace dyncal {

namespace {

PoleUncertainty withClock(const Pole &pole, const UncertaintyLine &clock)
{
    return {
        .u_frequency_Hz = std::hypot(pole.u_frequency_Hz, clock.contribution * pole.frequency_Hz),
        .kFrequency = pole.coverageFactor,
        .u_dampingRatio = pole.u_dampingRatio,
        .kDamping = pole.coverageFactor};
}

PoleUncertainty asReported(const UncertaintyReport &report)
{
    const ReportedValue *f0 = report.find("f0_hz");
    const ReportedValue *zeta = report.find("damping_ratio");
    if (!f0 || !f0->u || !zeta || !zeta->u)
        return {};
    return {.u_frequency_Hz = *f0->u,
        .kFrequency = f0->k,
        .u_dampingRatio = *zeta->u,
        .kDamping = zeta->k,
        .leastFrequency_Hz = f0->leastExpanded,
        .leastDamping = zeta->leastExpanded};
}

/// A pair is one resonance; a sensor of damping ratio 1 and more has one that no pole has.
bool isOf(const std::optional<SensorResonance> &resonance, const Pole &pole)
{
    constexpr double kRounding = 1e-9;
    return resonance
        && std::abs(pole.frequency_Hz - resonance->frequency_Hz)
        <= kRounding * resonance->frequency_Hz
        && std::abs(pole.dampingRatio - resonance->dampingRatio) <= kRounding;
}

} // namespace

std::vector<PoleUncertainty> statedPoles(
    const SensorModel &model, const ModelAssessment *assessment, const UncertaintyReport *report)
{
    const std::vector<Pole> &poles = polesOf(model, assessment);
    std::vector<PoleUncertainty> stated(poles.size());
    if (!report)
        return stated;
    const auto resonance = sensorResonance(&model, assessment);
    const PoleUncertainty ofResonance = asReported(*report);
    for (std::size_t i = 0; i < poles.size(); ++i) {
        stated[i] = isOf(resonance, poles[i]) && std::isfinite(ofResonance.u_frequency_Hz)
            ? ofResonance
            : withClock(poles[i], report->chain.clock);
        if (i < report->amplitudes.size() && report->amplitudes[i].u) {
            stated[i].u_amplitude = *report->amplitudes[i].u;
            stated[i].kAmplitude = report->amplitudes[i].k;
        }
    }
    return stated;
}

std::optional<StatedResonance> statedResonance(
    const SensorModel *model, const ModelAssessment *assessment, const UncertaintyReport *report)
{
    const auto found = sensorResonance(model, assessment);
    if (!found)
        return std::nullopt;
    return StatedResonance{
        found->frequency_Hz, found->dampingRatio, report ? asReported(*report) : PoleUncertainty()};
}

} // namespace dyncal
