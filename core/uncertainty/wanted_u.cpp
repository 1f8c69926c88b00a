// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/wanted_u.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

InputShare &shareOf(const std::string &quantity, std::vector<InputShare> &inputs)
{
    const auto found = std::ranges::find(inputs, quantity, &InputShare::quantity);
    return found != inputs.end() ? *found : inputs.emplace_back(InputShare{quantity});
}

std::vector<InputShare> inputShares(const std::vector<UncertaintyLine> &lines)
{
    std::vector<InputShare> inputs;
    for (const UncertaintyLine &line : lines) {
        if (line.quantity == kCapability)
            continue;
        InputShare &input = shareOf(line.quantity, inputs);
        input.contribution = std::hypot(input.contribution, line.contribution);
    }
    std::ranges::stable_sort(inputs, std::greater(), &InputShare::contribution);
    return inputs;
}

/// What is left of the variance without the inputs from `first` to `last`. Summed anew, as a
/// difference of large numbers would leave rounding errors where nothing is left.
double varianceWithout(
    std::vector<UncertaintyLine> lines, const InputShare *first, const InputShare *last)
{
    std::erase_if(lines, [&](const UncertaintyLine &line) {
        return line.quantity == kCapability
            || std::find_if(first, last,
                   [&](const InputShare &input) { return input.quantity == line.quantity; })
            != last;
    });
    return std::pow(combined(lines).u, 2);
}

/// The f with C^2 f^2 + 2 K f + rest = u_w^2: C is the input's own, K = sum of r c_x c_i what it
/// has with others (0 where nothing is correlated).
std::optional<double> factorOf(
    const InputShare &one, const std::vector<UncertaintyLine> &lines, double wanted_u)
{
    const double rest = varianceWithout(lines, &one, &one + 1);
    const double C = one.contribution;
    const double K = areCorrelated(lines)
        ? 0.5 * (varianceWithout(lines, nullptr, nullptr) - rest - C * C)
        : 0.0;
    const double root = K * K + C * C * (wanted_u * wanted_u - rest);
    if (root < 0.0 || !(C > 0.0) || std::sqrt(root) < K)
        return std::nullopt;
    return (std::sqrt(root) - K) / (C * C);
}

} // namespace

std::optional<WayToU> wayToU(const ReportedValue &reported, const WantedU &wanted)
{
    const double wanted_u = wanted.relative * std::abs(reported.value) / wanted.k;
    if (!reported.u || !(wanted_u > 0.0))
        return std::nullopt;
    WayToU way;
    way.wanted_u = wanted_u;
    way.isReached = *reported.u <= wanted_u;
    way.isBelowCapability = !way.isReached && wanted.k * wanted_u < reported.leastExpanded;
    if (way.isBelowCapability)
        return way;
    way.inputs = inputShares(reported.lines);
    for (InputShare &input : way.inputs)
        input.factor = factorOf(input, reported.lines, wanted_u);
    const InputShare *inputs = way.inputs.data();
    while (!way.isReached && way.toRemove < way.inputs.size()
        && varianceWithout(reported.lines, inputs, inputs + way.toRemove) > wanted_u * wanted_u)
        ++way.toRemove;
    return way;
}

} // namespace dyncal
