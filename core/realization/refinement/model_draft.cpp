// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/model_draft.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

double energyOverNoise(const ModelSeries &series, const ExponentialSum &sum, Index i, double dt_s)
{
    constexpr double kRounding = 1e-20;
    const std::complex<double> s = sum.poles_rad_s[i];
    const double noise
        = std::max(series.noiseSd * series.noiseSd, kRounding * series.y.squaredNorm());
    const double first
        = std::norm(sum.amplitudes[i] * series.filter.delayedGain(s, series.first_s));
    const double decay = std::norm(std::exp(s * dt_s));
    const double samples = static_cast<double>(series.y.size());
    const double count = std::abs(1.0 - decay) > 1e-12
        ? (1.0 - std::pow(decay, samples)) / (1.0 - decay)
        : samples;
    return 2.0 * first * count / noise;
}

std::vector<bool> standingOut(const ModelInput &input, const ModelDraft &draft)
{
    std::vector<bool> result(draft.poles_rad_s.size(), false);
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (energyOverNoise(input.series[r], draft.series[r], static_cast<Index>(i),
                    sampleInterval_s(input))
                > kStandsOut)
                result[i] = true;
        }
    }
    return result;
}

} // namespace dyncal
