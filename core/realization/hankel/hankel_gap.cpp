// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_gap.h"

#include "core/base/number_text.h"
#include "core/realization/hankel/realized_poles.h"

#include <algorithm>
#include <complex>
#include <vector>

namespace dyncal {
namespace {

constexpr double kSurely = 1.3; ///< of the noise's 95 % edge; noise alone does not reach it
constexpr double kRoundingOfValues = 1e-10; ///< of the largest singular value
constexpr double kClearGap = 3.0;

Index oscillatingPairs(const HankelDecomposition &decomposition, Index order)
{
    const std::vector<std::complex<double>> poles = realizedPoles(decomposition, order);
    return std::ranges::count_if(
        poles, [](const std::complex<double> &z) { return z.imag() > 0.0; });
}

} // namespace

bool splitsPair(const HankelDecomposition &decomposition, Index order)
{
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    if (order < 1 || order >= largestOrder(decomposition))
        return false;
    // Values within the noise, or within the rounding of noise-free data, belong to no oscillation.
    const double least
        = std::max(kSurely * decomposition.noiseFloor_p95, kRoundingOfValues * sigma[0]);
    return sigma[order] > least
        && oscillatingPairs(decomposition, order + 1) > oscillatingPairs(decomposition, order);
}

Findings judgeGap(const HankelDecomposition &decomposition)
{
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    double widest = 0.0;
    for (Index n = 1; n < sigma.size() && sigma[n - 1] > decomposition.noiseFloor_p95; ++n)
        widest = std::max(widest, sigma[n - 1] / sigma[n]);
    if (sigma.size() < 2 || widest > kClearGap)
        return {};
    return {{.id = "ORD-002",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core",
               "No clear gap between the singular values: none above the noise is more than %1 times the next. Compare candidates."),
            {numberText(kClearGap, 2)}},
        .value = widest,
        .limit = kClearGap}};
}

} // namespace dyncal
