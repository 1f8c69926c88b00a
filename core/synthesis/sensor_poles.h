// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/synthesis/sensor_spec.h"

#include <complex>
#include <vector>

namespace dyncal {

/// The two poles of a mode in rad/s. Damping within 1e-8 of 1 is moved to 1 - 1e-8, so that the
/// poles stay distinct (the response changes by less than 1e-8).
std::vector<std::complex<double>> modePoles(const SensorMode &mode);

/// Distances from 0 of the real poles that all modes share, in rad/s: real pole, AC coupling, heat.
std::vector<double> sharedRealPoles_per_s(const SensorSpec &sensor);

} // namespace dyncal
