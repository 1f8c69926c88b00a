// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"

namespace dyncal {

/// Fits the poles to every shot alone and to the shots of every level, tests whether the shots
/// share them (docs/method/model.md) and fills in perShot, perLevel and homogeneity. Where a pole
/// fails, its uncertainty in the assessment (before: that of the refinement) becomes the scatter
/// between the shots, with Student's factor. Does nothing without a refinement.
void compareShots(const ModelInput &input, const SensorModel &model, ModelAssessment &assessment,
    const JobControl &control);

/// MOD-010: the shots do not share the main resonance, or another pole of the sensor.
Findings judgeShots(const ModelAssessment &assessment);

} // namespace dyncal
