// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/chain_effects.h"

#include "core/realization/exponentials/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dyncal {
namespace {

/// Half width of a rectangle as a standard uncertainty.
double rectangle(double halfWidth)
{
    return halfWidth / std::sqrt(3.0);
}

UncertaintyLine effect(const std::vector<StatedUncertainty> &stated, const char *quantity,
    double otherwise, Distribution distribution)
{
    const auto found
        = std::ranges::find(stated, std::string(quantity), &StatedUncertainty::quantity);
    UncertaintyLine line = found == stated.end()
        ? directLine(quantity, otherwise, std::numeric_limits<double>::infinity(), distribution)
        : directLine(quantity, found->u,
            found->dof.value_or(std::numeric_limits<double>::infinity()), found->distribution);
    line.value = 0.0;
    if (found != stated.end())
        line.correlated = found->correlated;
    return line;
}

/// A gain that is larger than it should be makes the sensitivity smaller than it is found.
UncertaintyLine divided(UncertaintyLine line)
{
    line.sensitivity = -line.sensitivity;
    line.contribution = -line.contribution;
    return line;
}

} // namespace

ChainEffects chainEffects(const std::vector<StatedUncertainty> &stated)
{
    return {{divided(effect(stated, "gain_relative", rectangle(0.005), Distribution::Rectangular)),
                effect(stated, "linearity_relative", rectangle(0.001), Distribution::Rectangular),
                effect(stated, kMounting, 0.001, Distribution::Normal)},
        effect(stated, "clock_relative", rectangle(50e-6), Distribution::Rectangular)};
}

const UncertaintyLine &mountingOf(const ChainEffects &chain)
{
    return *std::ranges::find(chain.ofSensitivity, kMounting, &UncertaintyLine::quantity);
}

UncertaintyLine frontLine(double frequency_Hz)
{
    constexpr double kNearestToZero = 0.9; // of f T; at 1 the front takes all
    const double x = std::numbers::pi * std::min(frequency_Hz * kUnstatedFront_s, kNearestToZero);
    const double g = x > 0.0 ? x / std::sin(x) - 1.0 : 0.0;
    UncertaintyLine line = directLine("front_unknown", g / std::sqrt(5.0));
    line.value = 0.0;
    return line;
}

} // namespace dyncal
