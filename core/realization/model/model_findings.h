// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/spectrum_analysis.h"

#include <complex>
#include <vector>

namespace dyncal {

/// What the operator must see about a realised model: ORD-001, ORD-003, MOD-001..006, 008, 009,
/// 013.
Findings judgeModel(const SensorModel &model, const ModelInput &input,
    const HankelDecomposition &decomposition, const SpectrumResult &spectrum);

/// Adds to every pole's flags: "step", "nyquist", "unstable", "near-cancelled" (a zero within 1e-3
/// in the z plane), "integrator" (real, as slow as its own standard uncertainty allows). They come
/// after "below-noise", which is set with the class.
void flagPoles(const std::vector<std::complex<double>> &zeros, std::vector<Pole> &poles);

} // namespace dyncal
