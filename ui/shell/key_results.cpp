// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/key_results.h"

#include "core/base/constants.h"
#include "core/base/rounding.h"
#include "core/pipeline/calibration_kind.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct Key
{
    Q_DECLARE_TR_FUNCTIONS(KeyResults)
};

KeyResult entry(
    const char *name, const QString &symbol, double value, double u, const QString &unit)
{
    return {name, symbol + " " + shownConcisely(value, u, unit, kDigitsWithoutUncertainty), {}};
}

KeyResult sensitivityOf(const CalibrationResults &results)
{
    const ResponseResult *response = results.response.get();
    KeyResult result = entry("keySensitivity", QStringLiteral("S"),
        response ? response->sensitivity.value_or(kUnknown) : kUnknown,
        uOfSensitivity(results.uncertainty.get()),
        response ? shownText(response->sensitivityUnit) : QString());
    result.meaning = Key::tr(
        "Sensitivity: the level at the onset of the step over the pressure step, mean of the shots; in brackets the standard uncertainty u of its last digits (k = 1), where that of the step is known.");
    return result;
}

/// The largest step, which the sensitivity rests on most.
const ShockConditions *largestStep(const CalibrationResults &results, const Recipe &recipe)
{
    const ShockConditions *largest = nullptr;
    if (const ShockConditionsSet *steps = stepsUsed(results, recipe))
        for (const ShockConditions &shot : steps->shots)
            if (shot.step_Pa && (!largest || *shot.step_Pa > *largest->step_Pa))
                largest = &shot;
    return largest;
}

KeyResult stepOf(const CalibrationResults &results, const Recipe &recipe)
{
    const ShockConditions *shot = largestStep(results, recipe);
    const double u = shot && shot->uncertainty
        ? shot->uncertainty->u(StepResult::Step).value_or(kUnknown)
        : kUnknown;
    KeyResult result = entry(
        "keyStep", QStringLiteral("Δp"), shot ? *shot->step_Pa : kUnknown, u, QStringLiteral("Pa"));
    result.meaning = shot
        ? Key::tr(
            "Pressure step of shot %1, the largest; in brackets the standard uncertainty u of its last digits (k = 1).")
              .arg(shot->shot)
        : Key::tr("Pressure step: not determined yet.");
    return result;
}

} // namespace

std::vector<KeyResult> keyResults(const CalibrationResults &results, const Recipe &recipe)
{
    const auto pole = sensorResonance(results.model.get(), results.assessment.get());
    KeyResult frequency
        = entry("keyFrequency", QStringLiteral("f₀"), pole ? pole->frequency_Hz : kUnknown,
            uOf(results.uncertainty.get(), "f0_hz"), QStringLiteral("Hz"));
    frequency.meaning = Key::tr(
        "Undamped natural frequency of the sensor; in brackets the standard uncertainty u of its last digits (k = 1).");
    KeyResult damping = entry("keyDamping", QStringLiteral("ζ"),
        pole ? pole->dampingRatio : kUnknown, uOf(results.uncertainty.get(), "damping_ratio"), {});
    damping.meaning = Key::tr(
        "Damping ratio of the sensor; in brackets the standard uncertainty u of its last digits (k = 1).");
    if (calibrationKind(results, recipe) == CalibrationKind::FreeDecay)
        return {frequency, damping};
    return {sensitivityOf(results), frequency, damping, stepOf(results, recipe)};
}

} // namespace dyncal
