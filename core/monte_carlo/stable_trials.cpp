// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/stable_trials.h"

#include "core/base/input_draws.h"

#include <cmath>

namespace dyncal {
namespace {

using Batches = std::vector<std::vector<DrawnQuantity>>;

double meanOver(const Batches &batches, std::size_t quantity, double DrawnQuantity::*member)
{
    double sum = 0.0;
    for (const auto &batch : batches)
        sum += batch[quantity].*member;
    return sum / static_cast<double>(batches.size());
}

/// Standard deviation of that mean (7.9.4, step f).
double spreadOver(const Batches &batches, std::size_t quantity, double DrawnQuantity::*member)
{
    const double mean = meanOver(batches, quantity, member);
    double squares = 0.0;
    for (const auto &batch : batches)
        squares += std::pow(batch[quantity].*member - mean, 2);
    const auto n = static_cast<double>(batches.size());
    return std::sqrt(squares / (n * (n - 1.0)));
}

/// Up to four degrees of freedom u of a batch has no variance: no number of batches settles it, and
/// the interval alone is looked at.
bool hasSpreadOfU(const Batches &batches, std::size_t quantity)
{
    return batches.front()[quantity].leastDof > 4.0;
}

double meanWidth(const Batches &batches, std::size_t quantity)
{
    return meanOver(batches, quantity, &DrawnQuantity::high)
        - meanOver(batches, quantity, &DrawnQuantity::low);
}

bool isSettled(const Batches &batches, std::size_t quantity, int digits)
{
    const bool hasSpread = hasSpreadOfU(batches, quantity);
    const double u = hasSpread ? meanOver(batches, quantity, &DrawnQuantity::u)
                               : 0.25 * meanWidth(batches, quantity);
    if (!(u > 0.0))
        return true;
    const double tolerance = numericalTolerance(u, digits);
    const auto isSettledIn = [&](double DrawnQuantity::*member) {
        return 2.0 * spreadOver(batches, quantity, member) <= tolerance;
    };
    return isSettledIn(&DrawnQuantity::low) && isSettledIn(&DrawnQuantity::high)
        && (!hasSpread || (isSettledIn(&DrawnQuantity::mean) && isSettledIn(&DrawnQuantity::u)));
}

} // namespace

bool areStable(const Batches &batches, int digits)
{
    if (batches.size() < 2)
        return false;
    for (std::size_t i = 0; i < batches.front().size(); ++i)
        if (!isSettled(batches, i, digits))
            return false;
    return true;
}

} // namespace dyncal
