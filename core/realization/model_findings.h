// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/realization/sensor_model.h"

namespace dyncal {

/// Whether order n cuts an oscillating pair in two (ORD-001): the next singular value is above the
/// noise, and with it one pole more oscillates; order n has a real pole in the pair's place. Their
/// singular values do not tell: those of a pair differ by more than 5 % where it decays within the
/// Hankel matrix.
bool splitsPair(const HankelDecomposition &decomposition, Index order);

/// What the operator must see about a realised model: ORD-001, ORD-003, MOD-001..006, 008, 009.
Findings judgeModel(const SensorModel &model, const ModelInput &input,
    const HankelDecomposition &decomposition, const SpectrumResult &spectrum);

/// ORD-002: no singular value above the noise stands out of the next by more than a factor of 3.
Findings judgeGap(const HankelDecomposition &decomposition);

struct OrderEvidence;

/// MOD-007: the FIT of a shot by the poles of the other shots (orders 1..20) lies more than 15
/// points below that by the model's.
Findings judgeOtherShots(const SensorModel &model, const OrderEvidence &evidence);

/// Marks in every pole's flags what else the table says of it: "step", "nyquist", "unstable",
/// "near-cancelled" (a zero within 1e-3 in the z plane), "integrator" (real, as slow as its own
/// standard uncertainty allows). After "below-noise", which comes with the class.
void flagPoles(SensorModel &model);

} // namespace dyncal
