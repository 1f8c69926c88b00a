// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/pole_amplitudes.h"

#include "core/uncertainty/front_effect.h"
#include "core/uncertainty/model_noise.h"

#include <cmath>

namespace dyncal {
namespace {

double amplitudeAt(const SensorModel &model, Index i)
{
    return i < model.amplitudes.size() ? std::abs(model.amplitudes[i]) : kUnknown;
}

double uOfNoise(const Pole &assessed, const std::vector<ModelVariation> &variations, std::size_t i)
{
    const double u_Hz = spreadOver(
        variations, [i](const SensorModel &moved) { return moved.poles[i].frequency_Hz; });
    const double u_zeta = spreadOver(
        variations, [i](const SensorModel &moved) { return moved.poles[i].dampingRatio; });
    const double u = spreadOver(variations,
        [i](const SensorModel &moved) { return amplitudeAt(moved, static_cast<Index>(i)); });
    return u * widening(assessed.u_frequency_Hz, u_Hz, assessed.u_dampingRatio, u_zeta);
}

UncertaintyLine frontOf(const FrontVariation &front, Index i)
{
    const double change = amplitudeAt(front.longer, i) - amplitudeAt(front.shorter, i);
    return directLine(front.range.quantity, std::abs(change) / front.range.divisor);
}

} // namespace

std::vector<ReportedValue> poleAmplitudes(const SensorModel &model,
    const ModelAssessment &assessment, const std::vector<ModelVariation> &variations,
    const FrontDuration &front)
{
    const std::vector<Pole> &poles = polesOf(model, &assessment);
    const FrontVariation ofFront = frontVariation(model, front);
    std::vector<ReportedValue> reported;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        ReportedValue one{"amplitude", poles[i].amplitude, ""};
        const auto at = static_cast<Index>(i);
        const double u
            = at < model.amplitudes.size() ? uOfNoise(poles[i], variations, i) : kUnknown;
        if (std::isfinite(u)) {
            one.lines = {modelNoiseLine(u, model, assessment), frontOf(ofFront, at)};
            combineLines(one);
        } else {
            one.missing = {DYNCAL_TEXT("core", "the model was not refined"), {}};
        }
        reported.push_back(std::move(one));
    }
    return reported;
}

} // namespace dyncal
