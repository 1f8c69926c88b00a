// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// What a calibration can state. Words, sections and column heads of the certificate, the lines of
/// the summary and the window's key results follow from it and from nothing else.
enum class CalibrationKind {
    ComputedStep, ///< pressure steps computed from the shock: sensitivity and S(f) in V/Pa
    TypedStep, ///< every known step was stated by the operator: the same, no shock tube needed
    Transducer, ///< against a reference transducer beside the item: S(f) in V/Pa, no shock tube
                ///< needed
    UnknownStep, ///< no step is known: S(f) relative to the level at the onset, no sensitivity
    FreeDecay, ///< nobody knows what excited the item: poles only, no S(f)
};

const char *calibrationKindName(CalibrationKind kind); ///< "computed-step", ...

/// Decided from the results; where the stage that would tell is not computed, from the recipe,
/// which says what it will be. A single shot with a known step is enough for a sensitivity of that
/// shot; where steps of both sorts are known it is ComputedStep, and the table of the steps tells
/// them apart.
CalibrationKind calibrationKind(const CalibrationResults &results, const Recipe &recipe);

/// The pressure steps that the response is related to; null where there are none yet.
const ShockConditionsSet *stepsUsed(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal
