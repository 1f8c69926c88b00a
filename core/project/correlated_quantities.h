// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <array>

namespace dyncal {

/// What an entry of uncertainty.correlations may name: quantities with one value at all places;
/// those of sensors by place are not correlated by name.
inline constexpr std::array kCorrelatedQuantities{"p1_pa", "t1_k", "gamma", "molar_mass_kg_mol",
    "relative_humidity", "carbon_dioxide_fraction", "velocity_m_s", "step_relative",
    "gain_relative", "linearity_relative", "mounting_relative", "reference_gain_relative"};

} // namespace dyncal
