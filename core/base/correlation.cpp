// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dyncal {
namespace {

double coefficientOf(const Correlations &list, const std::string &quantity)
{
    const auto found = std::ranges::find(list, quantity, &Correlation::quantity);
    return found == list.end() ? 0.0 : found->coefficient;
}

double coefficientOf(const VariancePart &a, const VariancePart &b)
{
    if (a.shot > 0 && b.shot > 0 && a.shot != b.shot)
        return 0.0;
    const double stated = coefficientOf(a.correlated, b.quantity);
    return stated != 0.0 ? stated : coefficientOf(b.correlated, a.quantity);
}

bool isExact(const VariancePart &part)
{
    return !std::isfinite(part.dof) || !(part.dof > 0.0);
}

} // namespace

std::vector<double> varianceShares(const std::vector<VariancePart> &parts)
{
    std::vector<double> shares(parts.size(), 0.0);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        shares[i] += parts[i].contribution * parts[i].contribution;
        for (std::size_t j = 0; j < i; ++j) {
            const double crossed
                = coefficientOf(parts[i], parts[j]) * parts[i].contribution * parts[j].contribution;
            shares[i] += crossed;
            shares[j] += crossed;
        }
    }
    return shares;
}

CombinedUncertainty combinedParts(const std::vector<VariancePart> &parts)
{
    const std::vector<double> shares = varianceShares(parts);
    double variance = 0.0, fourth = 0.0;
    double together = 0.0, fewest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        variance += shares[i];
        if (!parts[i].correlated.empty()) {
            together += shares[i];
            fewest = isExact(parts[i]) ? fewest : std::min(fewest, parts[i].dof);
        } else if (!isExact(parts[i])) {
            fourth += shares[i] * shares[i] / parts[i].dof;
        }
    }
    fourth += together * together / fewest;
    CombinedUncertainty result{std::sqrt(std::max(0.0, variance))};
    if (fourth > 0.0)
        result.dof = variance * variance / fourth;
    return result;
}

} // namespace dyncal
