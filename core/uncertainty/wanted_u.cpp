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

/// What is left of the variance without the first `count` inputs. Summed anew, as a difference of
/// large numbers would leave rounding errors where nothing is left.
double varianceBehind(const std::vector<InputShare> &inputs, std::size_t count)
{
    double variance = 0.0;
    for (std::size_t i = count; i < inputs.size(); ++i)
        variance += inputs[i].contribution * inputs[i].contribution;
    return variance;
}

double varianceWithout(const std::vector<InputShare> &inputs, const InputShare &one)
{
    double variance = 0.0;
    for (const InputShare &input : inputs)
        variance += &input == &one ? 0.0 : input.contribution * input.contribution;
    return variance;
}

std::optional<double> factorOf(
    const InputShare &one, const std::vector<InputShare> &inputs, double wanted_u)
{
    const double room = wanted_u * wanted_u - varianceWithout(inputs, one);
    if (room < 0.0 || !(one.contribution > 0.0))
        return std::nullopt;
    return std::sqrt(room) / one.contribution;
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
        input.factor = factorOf(input, way.inputs, wanted_u);
    while (!way.isReached && way.toRemove < way.inputs.size()
        && varianceBehind(way.inputs, way.toRemove) > wanted_u * wanted_u)
        ++way.toRemove;
    return way;
}

} // namespace dyncal
