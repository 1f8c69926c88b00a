// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/row_sources.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dyncal {
namespace {

constexpr double kInfiniteDof = std::numeric_limits<double>::infinity();

double valueOr(const Eigen::VectorXd &list, Index row, double otherwise)
{
    return row < list.size() && std::isfinite(list[row]) ? list[row] : otherwise;
}

/// Mean over the shots of u(h)/(1 + jw tau), h of the step at the onset.
std::complex<double> driftOf(const DriftResult &drift, double omega)
{
    if (drift.kind != DriftKind::Heat || drift.shots.empty())
        return 0.0;
    std::complex<double> sum = 0.0;
    for (const ShotDrift &shot : drift.shots)
        sum += shot.u / std::abs(std::expm1(-shot.at_s / shot.tau_s))
            / std::complex<double>(1.0, omega * shot.tau_s);
    sum /= static_cast<double>(drift.shots.size());
    return std::isfinite(std::abs(sum)) ? sum : 0.0;
}

/// The onset's part of the phase's noise; 0 where it is not known.
double onsetOf(const ResponseResult &response, Index row, double noise)
{
    const double all = valueOr(response.u_noisePhase_rad, row, noise);
    return std::sqrt(std::max(0.0, all * all - noise * noise));
}

/// Of the noise alone, as the budget has it.
double dofOfNoise(const ReportedValue &phase)
{
    const auto line
        = std::ranges::find(phase.lines, std::string("noise"), &UncertaintyLine::quantity);
    return line == phase.lines.end() ? kInfiniteDof : line->dof;
}

} // namespace

RowSources rowSources(const ResponseResult &response, const ReportedValue &phase, Index row)
{
    const double S = response.magnitude[row];
    RowSources of;
    of.frequency_Hz = response.frequency_Hz[row];
    of.value = std::polar(S, response.phase_rad[row]);
    of.noise = response.u_noiseMagnitude[row] / S;
    of.dofNoise = dofOfNoise(phase);
    of.boundEnd = response.boundEnd[row] / S;
    of.boundAlias = response.boundAlias[row] / S;
    of.drift = driftOf(response.drift, kTwoPi * of.frequency_Hz);
    of.onset_rad = onsetOf(response, row, of.noise);
    of.reference = {valueOr(response.u_referenceMagnitude, row, 0.0) / S,
        valueOr(response.u_referencePhase_rad, row, 0.0),
        valueOr(response.dofReference, row, kInfiniteDof)};
    of.chain = {valueOr(response.u_chain_relative, row, 0.0),
        valueOr(response.u_chainPhase_rad, row, 0.0),
        valueOr(response.dofChain, row, kInfiniteDof)};
    return of;
}

} // namespace dyncal
