// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

namespace dyncal {

/// Speed of sound and ratio of heat capacities of moist air at rest, by O. Cramer, J. Acoust. Soc.
/// Am. 93 (1993) 2510: real gas, with water vapour and carbon dioxide.
struct MoistAir
{
    double soundSpeed_m_s = 0.0;
    double gamma = 0.0;
    double waterFraction = 0.0; ///< mole fraction of water vapour
};

/// `relativeHumidity` 0..1, `carbonDioxide` as mole fraction. Cramer's formula holds for 0..30
/// degC, 75..102 kPa, water up to a mole fraction of 0.06 and carbon dioxide up to 0.01: fails
/// (DataBlocked, SHK-009) outside, naming the quantity.
Result<MoistAir> moistAir(
    double pressure_Pa, double temperature_K, double relativeHumidity, double carbonDioxide);

/// Mole fraction of water vapour at that relative humidity (enhancement factor and saturation
/// pressure as in the same paper's appendix).
double waterFraction(double pressure_Pa, double temperature_K, double relativeHumidity);

} // namespace dyncal
