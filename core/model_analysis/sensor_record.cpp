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

void takeOff(const NuisanceTerm &term, double rate_Hz, Eigen::VectorXd &values)
{
    ExponentialSum sum{0.0, Eigen::VectorXcd(2), Eigen::VectorXcd(2)};
    sum.poles_rad_s << term.pole_rad_s, std::conj(term.pole_rad_s);
    sum.amplitudes << 0.5 * term.amplitude, 0.5 * std::conj(term.amplitude);
    const ExponentialSampler sampler(sum, 1.0 / rate_Hz);
    constexpr Index kBlock = ExponentialSampler::kBlock;
    for (Index begin = 0; begin < values.size(); begin += kBlock) {
        const Index count = std::min(kBlock, values.size() - begin);
        values.segment(begin, count) -= sampler.block(begin / kBlock).head(count);
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

/// Samples between onset and detected start, which is a little later; they are part of the
/// response.
Index samplesBetween(const WindowedResponse &response, double onset_s)
{
    return std::clamp<Index>(
        static_cast<Index>(std::floor(-onset_s * response.sampleRate_Hz)), 0, response.lead);
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
    SensorRecord record{response.window(), 0, {}, {}};
    if (!fit)
        return record;
    record.early = samplesBetween(response, fit->onset_s);
    record.values
        = response.values.segment(response.lead - record.early, response.length + record.early);
    const std::vector<NuisanceTerm> terms = termsOfShot(model, response.shot);
    for (NuisanceTerm term : terms) {
        term.amplitude *= std::exp(
            -term.pole_rad_s * (static_cast<double>(record.early) / response.sampleRate_Hz));
        takeOff(term, response.sampleRate_Hz, record.values);
    }
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
