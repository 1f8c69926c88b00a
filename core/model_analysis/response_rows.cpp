// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/response_rows.h"

#include "core/base/constants.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kLargestBound = 0.02; ///< of the magnitude: with more, a value is withheld
constexpr double kRoundingOfRate = 1e-9;

/// The larger bound decides why a value is withheld; none where noise alone is larger.
WithheldReason reasonOf(const ResponsePoint &point)
{
    if (!point.isCalibrated)
        return WithheldReason::NotCalibrated;
    if (!point.isChainKnown)
        return WithheldReason::ChainUnknown;
    if (!std::isfinite(point.magnitude)
        || point.bound() <= std::max(point.u_magnitude, kLargestBound * point.magnitude))
        return WithheldReason::None;
    return point.boundEnd > point.boundAlias ? WithheldReason::End : WithheldReason::Alias;
}

/// Of the bounds, each taken for the half width of a rectangular distribution.
double ofBounds(const ResponsePoint &point)
{
    return std::hypot(point.boundEnd, point.boundAlias) / std::sqrt(3.0);
}

/// Only the noise and the certificates of reference and chain rest on a number of readings
/// (Welch-Satterthwaite).
double dofOfRow(const ResponsePoint &point, double u)
{
    const auto share4 = [u](double part) { return u > 0.0 ? std::pow(part / u, 4) : 0.0; };
    const double ofNoise = point.dof / share4(point.u_magnitude);
    const double others
        = share4(point.u_reference) / point.dofReference + share4(point.u_chain) / point.dofChain;
    return others == 0.0 ? ofNoise : 1.0 / (1.0 / ofNoise + others);
}

void stateMagnitude(const ResponsePoint &point, Index k, ResponseResult &result)
{
    const double others = std::hypot(ofBounds(point), point.u_front, point.u_reference);
    const double u = std::hypot(point.u_magnitude, others, point.u_chain);
    result.magnitude[k] = point.magnitude;
    result.u_noiseMagnitude[k] = point.u_magnitude;
    result.u_frontMagnitude[k] = point.u_front;
    result.u_referenceMagnitude[k] = point.u_reference;
    result.u_referencePhase_rad[k] = point.u_referencePhase_rad;
    result.dofReference[k] = point.dofReference;
    result.u_magnitude[k] = u;
    result.dof[k] = dofOfRow(point, u);
}

void state(const ResponsePoint &point, Index k, ResponseResult &result)
{
    result.length_s[k] = point.length_s;
    result.boundEnd[k] = point.boundEnd;
    result.boundAlias[k] = point.boundAlias;
    const WithheldReason reason = reasonOf(point);
    result.withheld[static_cast<std::size_t>(k)] = reason;
    if (reason != WithheldReason::None)
        return;
    stateMagnitude(point, k, result);
    // The branch nearest the model's unwrapped phase, because points may lie far apart.
    const double reference = result.modelPhase_rad[k];
    result.phase_rad[k] = reference + std::remainder(point.phase_rad - reference, kTwoPi);
    result.u_noisePhase_rad[k] = point.u_phase_rad;
    const double u = std::hypot(
        point.u_phase_rad, ofBounds(point) / point.magnitude, point.u_referencePhase_rad);
    result.u_phase_rad[k] = std::hypot(u, point.u_chainPhase_rad);
}

} // namespace

void measureRows(const ResponseSource &source, double highest_Hz, ResponseResult &result)
{
    const Index count = result.frequency_Hz.size();
    for (auto *values : {&result.magnitude, &result.u_magnitude, &result.u_noiseMagnitude,
             &result.u_frontMagnitude, &result.u_referenceMagnitude, &result.u_referencePhase_rad,
             &result.dofReference, &result.phase_rad, &result.u_phase_rad, &result.u_noisePhase_rad,
             &result.dof, &result.boundEnd, &result.boundAlias, &result.length_s})
        values->setConstant(count, kUnknown);
    result.withheld.assign(static_cast<std::size_t>(count), WithheldReason::AboveRate);
    for (Index k = 0; k < count; ++k)
        if (result.frequency_Hz[k] <= (1.0 + kRoundingOfRate) * highest_Hz)
            state(source.at(result.frequency_Hz[k]), k, result);
}

std::optional<Index> measuredRowAt(const ResponseResult &response, double frequency_Hz)
{
    constexpr double kRounding = 1e-9;
    for (Index row = 0; row < response.magnitude.size(); ++row)
        if (std::abs(response.frequency_Hz[row] / frequency_Hz - 1.0) < kRounding
            && std::isfinite(response.magnitude[row]))
            return row;
    return std::nullopt;
}

} // namespace dyncal
