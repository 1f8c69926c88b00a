// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/chain_correction.h"

#include "core/base/constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

void divide(const ReferencePoint &chain, ResponsePoint &point)
{
    for (double *value : {&point.magnitude, &point.u_magnitude, &point.boundEnd, &point.boundAlias,
             &point.u_front, &point.u_reference})
        *value /= chain.magnitude;
    point.phase_rad = std::remainder(point.phase_rad - chain.phase_rad, kTwoPi);
    point.u_chain = point.magnitude * chain.u_magnitude / chain.magnitude;
    point.u_chainPhase_rad = chain.u_phase_rad;
    point.dofChain = chain.dof;
}

void divideValues(const ReferenceSensitivity &chain, const Eigen::VectorXd &frequency_Hz,
    Eigen::VectorXd &magnitude, Eigen::VectorXd &phase_rad)
{
    for (Index k = 0; k < magnitude.size(); ++k) {
        const auto found = chain.at(frequency_Hz[k]);
        magnitude[k] = found ? magnitude[k] / found->magnitude : kUnknown;
        phase_rad[k] = found ? phase_rad[k] - found->phase_rad : kUnknown;
    }
}

void stateChain(const ReferenceSensitivity &chain, ResponseResult &result)
{
    const Index count = result.frequency_Hz.size();
    for (auto *values : {&result.u_chain_relative, &result.u_chainPhase_rad, &result.dofChain})
        values->setConstant(count, kUnknown);
    for (Index k = 0; k < count; ++k) {
        const auto found = chain.at(result.frequency_Hz[k]);
        if (!found)
            continue;
        result.u_chain_relative[k] = found->u_magnitude / found->magnitude;
        result.u_chainPhase_rad[k] = found->u_phase_rad;
        result.dofChain[k] = found->dof;
    }
}

} // namespace

ChainCorrected::ChainCorrected(
    std::unique_ptr<ResponseSource> source, const ReferenceSensitivity &chain, double u_delay_s)
    : m_source(std::move(source))
    , m_chain(chain)
    , m_u_delay_s(u_delay_s)
{
}

ResponsePoint ChainCorrected::at(double frequency_Hz) const
{
    const auto chain = m_chain.at(frequency_Hz);
    if (!chain)
        return {.magnitude = kUnknown, .phase_rad = kUnknown, .isChainKnown = false};
    ResponsePoint point = m_source->at(frequency_Hz);
    divide(*chain, point);
    point.u_phase_rad = std::hypot(point.u_phase_rad, kTwoPi * frequency_Hz * m_u_delay_s);
    return point;
}

double uOnsetBehind(const ReferenceSensitivity &chain, double from_Hz, double to_Hz)
{
    constexpr double kStep = 1.1;
    double largest_s = 0.0;
    for (double f_Hz = from_Hz; f_Hz <= to_Hz; f_Hz *= kStep) {
        const auto found = chain.at(f_Hz);
        if (found && std::isfinite(found->phase_rad))
            largest_s = std::max(largest_s, std::abs(found->phase_rad) / (kTwoPi * f_Hz));
    }
    return largest_s / std::sqrt(3.0);
}

void divideModel(const ReferenceSensitivity &chain, ResponseResult &result)
{
    const ReferencePoint lowest = chain.lowest();
    result.isWithoutChain = true;
    result.u_chainLowest_relative = lowest.u_magnitude / lowest.magnitude;
    stateChain(chain, result);
    divideValues(chain, result.frequency_Hz, result.modelMagnitude, result.modelPhase_rad);
    divideValues(chain, result.modelCurve.frequency_Hz, result.modelCurve.magnitude,
        result.modelCurve.phase_rad);
}

} // namespace dyncal
