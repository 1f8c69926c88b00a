// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/model_noise.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

double spreadOver(const std::vector<ModelVariation> &variations,
    const std::function<double(const SensorModel &)> &valueOf)
{
    if (variations.empty())
        return kUnknown;
    double variance = 0.0;
    for (const ModelVariation &one : variations)
        variance += std::pow((valueOf(one.up) - valueOf(one.down)) / (2.0 * kVariation), 2);
    return std::sqrt(variance);
}

double widening(double assessed_Hz, double u_Hz, double assessedZeta, double u_zeta)
{
    return u_Hz > 0.0 && u_zeta > 0.0 ? std::max({1.0, assessed_Hz / u_Hz, assessedZeta / u_zeta})
                                      : 1.0;
}

UncertaintyLine modelNoiseLine(
    double u, const SensorModel &model, const ModelAssessment &assessment)
{
    const bool isScatter = assessment.homogeneity && !assessment.homogeneity->passed;
    const double dof
        = isScatter ? static_cast<double>(model.series.size()) - 1.0 : model.draft.noise.dof;
    return with(isScatter ? OverShots::Scatter : OverShots::Own, directLine("noise", u, dof));
}

} // namespace dyncal
