// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/refinement.h"
#include "core/signal/window_bands.h"

#include <vector>

namespace dyncal {

/// The stretches of a record that take part, but for what lies in its first seconds.
std::vector<SampleRange> usedBehind(const RefinementRecord &record, double skipped_s);

/// MOD-017: the main resonance is another one without the first 0.35 periods of the records. A
/// front that nobody stated, or a part faster than the model, spoils the beginning only. Compared
/// are the poles of both fits; where the model is right the shorter one differs by (J. A. Hausman,
/// Econometrica 46 (1978) 1251)
///     d^T (V_short - V_all)^-1 d = chi square of 2 degrees of freedom,
/// with V_short alone in coloured noise, where least squares is not the best estimate. Told at a
/// probability of 1e-4, where f0 or zeta moves by its u at least. `poles` are the assessed ones.
/// MOD-020 is the same of a free decay, without its first two periods or half its time constant: a
/// hammer's contact is no part of the decay.
/// Nothing without refinement or an oscillating pole, with a stated front, or where the shorter fit
/// does not converge.
Findings judgeEarlySamples(const ModelInput &input, const SensorModel &model,
    const std::vector<Pole> &poles, const JobControl &control = {});

} // namespace dyncal
