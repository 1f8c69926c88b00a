// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/uncertain_value.h"
#include "core/shock/step_inputs.h"

#include <vector>

namespace dyncal {

/// What the chain behind the sensor and its mounting may change, which no record shows. Each is
/// stated (uncertainty.budget of the recipe), or taken as a data sheet of such an instrument has
/// it: unknown is not zero (docs/method/uncertainty.md).
struct ChainEffects
{
    /// Relative, of every value per pressure: "gain_relative" (converter and amplifier, rectangular
    /// +-0.5 %), "linearity_relative" (+-0.1 %), "mounting_relative" (0.1 %).
    std::vector<UncertaintyLine> ofSensitivity;
    UncertaintyLine clock; ///< "clock_relative", of every frequency and time: +-50 ppm
};

/// Of the chain's response where a table of it is divided out: of a row, and of the sensitivity.
inline constexpr const char *kChainResponse = "chain";
inline constexpr const char *kChainLevel = "chain_relative";

inline constexpr const char *kMounting = "mounting_relative";

ChainEffects chainEffects(const std::vector<StatedUncertainty> &stated);

/// The line of ofSensitivity that changes shapes, too: kMounting, which every chain has.
const UncertaintyLine &mountingOf(const ChainEffects &chain);

/// "front_unknown": by what |S| at one frequency may be larger than stated, relative, because of
/// such a front, anything from 0 to kUnstatedFront_s: with g = 1/sinc(f T) - 1 at its end, g T^2
/// over a rectangle of T has the root mean square g / sqrt(5) about the value that is stated, that
/// of a sharp front. From 0.9/kUnstatedFront_s on it is that of 0.9 (3.6 times the value), where
/// nothing is known of |S|.
UncertaintyLine frontLine(double frequency_Hz);

} // namespace dyncal
