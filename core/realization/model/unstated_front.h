// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// MOD-019: nobody stated a front, and the beginning of the records shows one longer than
/// kUnstatedFront_s, which the uncertainties allow for, and than three points: samples, or means of
/// so many that a period has some 200. A second-order sensor behind a front of free duration is
/// fitted to the first 5 periods, or 10 time constants of the main resonance; the same with the
/// longest that is allowed for costs more by chi square of one degree of freedom, told at a
/// probability of 1e-4. Only where that sensor describes the beginning better than the model, by
/// their BIC (docs/method/front.md). `poles` are the assessed ones. Nothing in thesis mode, without
/// an oscillating pole, or with a stated front.
Findings judgeUnstatedFront(const ModelInput &input, const SensorModel &model,
    const std::vector<Pole> &poles, const JobControl &control = {});

} // namespace dyncal
