// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/drift.h"

#include "core/base/constants.h"
#include "core/realization/model/onset_level.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// Change of the response by the slow parts from the onset to `t_s`, relative to the level.
double modelledChange(const SensorModel &model, const SeriesFit &fit, double t_s)
{
    double change = 0.0;
    for (const Index i : model.slowPoles)
        change += fit.amplitudes[i].real()
            * std::expm1(model.poles[static_cast<std::size_t>(i)].s_rad_s.real() * t_s);
    return change / fit.level();
}

/// Time constant of an AC coupling that has lost so much at that time; not above 0 where it cannot
/// be one.
double couplingTime_s(const ShotDrift &drift)
{
    return drift.relative > -1.0 && drift.relative < 0.0 ? -drift.at_s / std::log1p(drift.relative)
                                                         : 0.0;
}

/// Whether a coupling through the settle band also makes the change that the model saw by `span_s`.
bool isCoupling(const ShotDrift &drift, double change, double span_s)
{
    constexpr double kSigmas = 6.0; // of the level; the change is known about half as well
    constexpr double kSlack = 0.1;
    const double tau_s = couplingTime_s(drift);
    if (!(tau_s > 0.0))
        return false;
    const double expected = std::expm1(-span_s / tau_s);
    return std::abs(change - expected) <= kSigmas * drift.u + kSlack * std::abs(expected);
}

/// tau of h (1 - e^(-t/tau)) through both points: the ratio of the two changes falls from
/// at/span to 1 as tau falls. 0 where no tau has that ratio.
double timeThrough(const ShotDrift &drift, double change, double span_s)
{
    constexpr int kHalvings = 60;
    const double ratio = drift.relative / change;
    if (!(ratio > 1.0) || !(ratio < drift.at_s / span_s))
        return 0.0;
    double fast = 1e-3 * span_s;
    double slow = 1e3 * drift.at_s;
    for (int i = 0; i < kHalvings; ++i) {
        const double tau = std::sqrt(fast * slow);
        const double here = std::expm1(-drift.at_s / tau) / std::expm1(-span_s / tau);
        (here < ratio ? fast : slow) = tau;
    }
    return std::sqrt(fast * slow);
}

/// The curve of the model's largest slow part, where the two points make none.
void takeModel(const SensorModel &model, const SeriesFit &fit, ShotDrift &drift)
{
    const Index largest = *std::ranges::max_element(
        model.slowPoles, {}, [&](Index i) { return std::abs(fit.amplitudes[i]); });
    drift.tau_s = -1.0 / model.poles[static_cast<std::size_t>(largest)].s_rad_s.real();
    drift.share = fit.amplitudes[largest].real() / fit.level();
}

ShotDrift observed(const WindowedResponse &response, const SeriesFit &fit)
{
    const double level = fit.level() * response.valueScale;
    const double inBand = response.step / level;
    const double samples = std::max(1.0, response.sampleRate_Hz * response.settle_s.length());
    const double u_band = response.noiseSd / std::sqrt(samples) / level;
    ShotDrift drift;
    drift.shot = response.shot;
    drift.relative = inBand - 1.0;
    drift.u = std::hypot(inBand * fit.u_level() / fit.level(), u_band);
    drift.at_s = 0.5 * (response.settle_s.begin + response.settle_s.end) - fit.onset_s;
    return drift;
}

void takeHeat(const SensorModel &model, const SeriesFit &fit, double span_s, ShotDrift &drift)
{
    const double change = modelledChange(model, fit, span_s);
    drift.tau_s = timeThrough(drift, change, span_s);
    if (drift.tau_s > 0.0)
        drift.share = drift.relative / std::expm1(-drift.at_s / drift.tau_s);
    else
        takeModel(model, fit, drift);
}

} // namespace

const char *driftKindName(DriftKind kind)
{
    switch (kind) {
    case DriftKind::None:
        return "none";
    case DriftKind::Heat:
        return "heat";
    case DriftKind::AcCoupling:
        return "ac-coupling";
    case DriftKind::Undetermined:
        break;
    }
    return "undetermined";
}

const ShotDrift *DriftResult::ofShot(Index shot) const
{
    const auto found = std::ranges::find(shots, shot, &ShotDrift::shot);
    return found == shots.end() ? nullptr : &*found;
}

std::complex<double> DriftResult::keptAt(double frequency_Hz) const
{
    if (kind == DriftKind::None || kind == DriftKind::Heat || shots.empty())
        return 1.0;
    std::complex<double> sum = 0.0;
    for (const ShotDrift &drift : shots) {
        const std::complex<double> turns(0.0, kTwoPi * frequency_Hz * drift.tau_s);
        sum += 1.0 - drift.share / (1.0 + turns);
    }
    return sum / static_cast<double>(shots.size());
}

DriftResult findDrift(
    const std::vector<WindowedResponse> &responses, const SensorModel &model, double span_s)
{
    constexpr double kMostHeat = 0.5;
    DriftResult result;
    if (model.slowPoles.empty())
        return result;
    std::size_t couplings = 0;
    bool mayBeHeat = true;
    for (const WindowedResponse &response : responses) {
        const auto fit = std::ranges::find(model.series, response.shot, &SeriesFit::shot);
        if (fit == model.series.end())
            continue;
        ShotDrift drift = observed(response, *fit);
        if (isCoupling(drift, modelledChange(model, *fit, span_s), span_s)) {
            drift.tau_s = couplingTime_s(drift);
            drift.share = 1.0;
            ++couplings;
        } else {
            takeHeat(model, *fit, span_s, drift);
        }
        mayBeHeat = mayBeHeat && std::abs(drift.share) < kMostHeat && drift.tau_s > 0.0;
        result.shots.push_back(drift);
    }
    result.kind = couplings == result.shots.size() && couplings > 0 ? DriftKind::AcCoupling
        : mayBeHeat                                                 ? DriftKind::Heat
                                                                    : DriftKind::Undetermined;
    return result;
}

std::complex<double> modelledDrift(const SensorModel &model, double frequency_Hz)
{
    if (model.slowPoles.empty())
        return 1.0;
    ExponentialSum sum{
        model.plateauGain, Eigen::VectorXcd(model.amplitudes.size()), model.amplitudes};
    std::vector<bool> isSlow(static_cast<std::size_t>(model.amplitudes.size()), false);
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
        sum.poles_rad_s[i] = model.poles[static_cast<std::size_t>(i)].s_rad_s;
    for (const Index i : model.slowPoles)
        isSlow[static_cast<std::size_t>(i)] = true;
    const OnsetLevel level = onsetLevel(sum, isSlow);
    const std::complex<double> jw(0.0, kTwoPi * frequency_Hz);
    std::complex<double> gain = model.plateauGain;
    std::size_t at = 0;
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
        if (isSlow[static_cast<std::size_t>(i)])
            gain += level.slow[at++] * jw / (jw - sum.poles_rad_s[i]);
    return gain / level.value;
}

} // namespace dyncal
