// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/step_characteristics.h"
#include "core/realization/exponentials/exponential_sum.h"

namespace dyncal {

/// No later value of the sum is farther from its constant; of poles that decay.
double restAfter(const ExponentialSum &y, double t_s);

/// Rise time, settling time into 1 +- `settled`, overshoot and its time of a step response of level
/// 1 whose poles all decay, followed on a grid of forty points per radian of its fastest part until
/// nothing can change them; passages by bisection to full precision.
StepCharacteristics describedStep(const ExponentialSum &y, double settled);

} // namespace dyncal
