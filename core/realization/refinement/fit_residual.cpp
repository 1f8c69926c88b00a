// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/fit_residual.h"

#include <algorithm>

namespace dyncal {

std::vector<SampleRange> usedRanges(const RefinementRecord &record)
{
    return record.used.empty() ? std::vector<SampleRange>{{0, record.y.size()}} : record.used;
}

Eigen::VectorXd fitResidual(const RefinementRecord &record, const ExponentialSum &sum,
    const std::vector<NuisanceTerm> &terms)
{
    ExponentialSum whole = sum;
    for (const NuisanceTerm &term : terms) {
        const Index n = whole.poles_rad_s.size();
        whole.poles_rad_s.conservativeResize(n + 1);
        whole.amplitudes.conservativeResize(n + 1);
        whole.poles_rad_s[n] = term.pole_rad_s; // its real part alone is sampled
        whole.amplitudes[n] = term.amplitude;
    }
    const ExponentialSampler sampler(whole, 1.0 / record.rate_Hz);
    Eigen::VectorXd residual = record.y;
    for (Index begin = 0; begin < residual.size(); begin += ExponentialSampler::kBlock) {
        const Index size = std::min(ExponentialSampler::kBlock, residual.size() - begin);
        residual.segment(begin, size)
            -= sampler.block(begin / ExponentialSampler::kBlock).head(size);
    }
    Index kept = 0;
    for (const SampleRange &range : usedRanges(record)) {
        residual.segment(kept, range.size()) = residual.segment(range.begin, range.size()).eval();
        kept += range.size();
    }
    return residual.head(kept);
}

} // namespace dyncal
