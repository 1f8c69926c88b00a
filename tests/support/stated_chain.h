// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/chain_effects.h"

namespace dyncal::testing {

/// A chain and a mounting of which all is known but the clock and what the mounting adds.
inline ChainEffects statedChain(double u_clock = 0.0, double u_mounting = 0.0)
{
    const auto stated = [](const char *quantity, double u) {
        return StatedUncertainty{quantity, u, Distribution::Normal, {}};
    };
    return chainEffects({stated("gain_relative", 0.0), stated("linearity_relative", 0.0),
        stated(kMounting, u_mounting), stated("clock_relative", u_clock)});
}

} // namespace dyncal::testing
