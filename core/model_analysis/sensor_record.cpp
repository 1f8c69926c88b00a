// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/sensor_record.h"

#include "core/model_analysis/drift.h"
#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/signal/window_bands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

std::vector<NuisanceTerm> termsOfShot(const SensorModel &model, Index shot)
{
    std::vector<NuisanceTerm> terms;
    for (const NuisanceResult &mode : model.nuisance) {
        for (const NuisanceOfShot &found : mode.perShot) {
            if (found.shot == shot)
                terms.push_back(found.term);
        }
    }
    return terms;
}

/// A mode that the step sets off is in the record from the onset on, another in all of it.
void takeOff(const NuisanceTerm &term, double onset_s, double rate_Hz, SensorRecord &record)
{
    const Index first = term.startsWithStep
        ? std::max<Index>(0, record.early + static_cast<Index>(std::ceil(onset_s * rate_Hz)))
        : 0;
    const std::complex<double> amplitude = term.amplitude
        * std::exp(term.pole_rad_s * (static_cast<double>(first - record.early) / rate_Hz));
    ExponentialSum sum{0.0, Eigen::VectorXcd(2), Eigen::VectorXcd(2)};
    sum.poles_rad_s << term.pole_rad_s, std::conj(term.pole_rad_s);
    sum.amplitudes << 0.5 * amplitude, 0.5 * std::conj(amplitude);
    const ExponentialSampler sampler(sum, 1.0 / rate_Hz);
    constexpr Index kBlock = ExponentialSampler::kBlock;
    for (Index begin = first; begin < record.values.size(); begin += kBlock) {
        const Index count = std::min(kBlock, record.values.size() - begin);
        record.values.segment(begin, count) -= sampler.block((begin - first) / kBlock).head(count);
    }
}

/// Fills a stretch that is left out with the model's values; the range counts from the detected
/// start.
void bridgeOver(
    const SampleRange &range, const SeriesFit &fit, double rate_Hz, SensorRecord &record)
{
    const Index end = std::min(range.end, record.values.size() - record.early);
    for (Index i = range.begin; i < end; ++i)
        record.values[i + record.early] = fit.recorded.value(static_cast<double>(i) / rate_Hz);
}

/// The onset lies before the detected start: a little, or by as much as a slow sensor needs for the
/// first part of its step.
Index samplesBefore(const WindowedResponse &response)
{
    constexpr Index kFewest = 64;
    constexpr Index kShare = 16; // of the window
    return std::min(response.lead, std::max(kFewest, response.length / kShare));
}

/// jw/(jw - s) of Re(amplitude e^(s t)).
std::complex<double> stepTransformOf(
    std::complex<double> amplitude, std::complex<double> s, double frequency_Hz)
{
    const std::complex<double> jw(0.0, 2.0 * std::numbers::pi * frequency_Hz);
    return 0.5 * jw * (amplitude / (jw - s) + std::conj(amplitude) / (jw - std::conj(s)));
}

void takeOffDrift(const DriftResult &drift, Index shot, const SeriesFit &fit, double rate_Hz,
    SensorRecord &record)
{
    const ShotDrift *found = drift.ofShot(shot);
    if (!found)
        return;
    const double s = -1.0 / found->tau_s;
    const double c = found->share * fit.level();
    for (Index i = 0; i < record.values.size(); ++i) {
        const double t_s = static_cast<double>(i - record.early) / rate_Hz - fit.onset_s;
        record.values[i] -= t_s > 0.0 ? c * std::expm1(s * t_s) : 0.0;
    }
    record.slow.push_back({s, c, drift.kind == DriftKind::Heat ? found->share : 0.0});
}

} // namespace

std::complex<double> SensorRecord::ofStep(std::complex<double> transform, double frequency_Hz) const
{
    std::complex<double> input = 1.0;
    for (const Driven &mode : driven) {
        transform += stepTransformOf(mode.response, mode.pole_rad_s, frequency_Hz);
        input += stepTransformOf(mode.pressure, mode.pole_rad_s, frequency_Hz);
    }
    for (const Slow &mode : slow) {
        const std::complex<double> jw(0.0, 2.0 * std::numbers::pi * frequency_Hz);
        const std::complex<double> share = mode.rate_rad_s / (jw - mode.rate_rad_s);
        transform += mode.response * share;
        input += mode.pressure * share;
    }
    return transform / input;
}

SensorRecord sensorRecord(const WindowedResponse &response, const SensorModel &model,
    const SeriesFit *fit, const DriftResult &drift)
{
    const Index early = samplesBefore(response);
    SensorRecord record{
        response.values.segment(response.lead - early, response.length + early), early, {}, {}};
    if (!fit)
        return record;
    const std::vector<NuisanceTerm> terms = termsOfShot(model, response.shot);
    for (const NuisanceTerm &term : terms)
        takeOff(term, fit->onset_s, response.sampleRate_Hz, record);
    for (const SampleRange &range : fit->leftOut)
        bridgeOver(range, *fit, response.sampleRate_Hz, record);
    Eigen::ArrayXcd poles(fit->amplitudes.size());
    for (Index i = 0; i < poles.size(); ++i)
        poles[i] = model.poles[static_cast<std::size_t>(i)].s_rad_s;
    for (const NuisanceTerm &term : termsAt(terms, fit->onset_s)) {
        if (!term.startsWithStep)
            continue;
        const std::complex<double> s = term.pole_rad_s;
        const std::complex<double> gain
            = fit->plateauGain + (fit->amplitudes.array() * s / (s - poles)).sum();
        record.driven.push_back({s, term.amplitude, term.amplitude / gain});
    }
    takeOffDrift(drift, response.shot, *fit, response.sampleRate_Hz, record);
    return record;
}

} // namespace dyncal
