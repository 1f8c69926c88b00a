// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/realization/sensor_model.h"

namespace dyncal {

/// Whether the cut behind order n separates two nearly equal singular values above the noise, which
/// belong to one oscillating pair (ORD-001).
bool splitsPair(const HankelDecomposition &decomposition, Index order);

/// What the operator must see about a realised model: ORD-001, ORD-003, MOD-001..006, 008, 009.
Findings judgeModel(const SensorModel &model, const ModelInput &input,
    const HankelDecomposition &decomposition, const SpectrumResult &spectrum);

} // namespace dyncal
