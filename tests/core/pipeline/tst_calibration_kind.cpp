// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/calibration_kind.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QTest>

#include <set>
#include <string>

using namespace dyncal;
using testing::writable;
using enum dyncal::CalibrationKind;

namespace {

const ResponseTreatment kTreatments[] = {ResponseTreatment::StepDeflated,
    ResponseTreatment::StepAsImpulse, ResponseTreatment::Differenced, ResponseTreatment::Impulse};

} // namespace

class TestCalibrationKind : public QObject
{
    Q_OBJECT

private slots:
    void treatment_tellsDecayFromStep()
    {
        for (const ResponseTreatment treatment : kTreatments) {
            CalibrationResults results = example::calibration();
            writable(results.input).treatment = treatment;
            QCOMPARE(calibrationKind(results, {}),
                treatment == ResponseTreatment::Impulse ? FreeDecay : ComputedStep);
        }
    }

    void steps_tellTheRest()
    {
        CalibrationResults results = example::calibration();
        std::vector<ShockConditions> &shots = writable(results.shock).shots;
        QCOMPARE(calibrationKind(results, {}), ComputedStep);
        shots[0].stepTyped = true; // both sorts: the table of the steps tells them apart
        QCOMPARE(calibrationKind(results, {}), ComputedStep);
        shots[1].stepTyped = shots[2].stepTyped = true;
        QCOMPARE(calibrationKind(results, {}), TypedStep);
        shots[0].step_Pa.reset(); // the others still have a sensitivity
        QCOMPARE(calibrationKind(results, {}), TypedStep);
        shots[1].step_Pa.reset();
        shots[2].step_Pa.reset();
        QCOMPARE(calibrationKind(results, {}), UnknownStep);
    }

    void resultsWinOverTheRecipe()
    {
        // The recipe of the next run does not change what this one has computed.
        Recipe recipe;
        recipe.input.treatment = ResponseTreatment::Impulse;
        recipe.shock.enabled = false;
        QCOMPARE(calibrationKind(example::calibration(), recipe), ComputedStep);
    }

    void beforeTheResults_theRecipeTells()
    {
        Recipe recipe;
        QCOMPARE(calibrationKind({}, recipe), ComputedStep);
        recipe.shock.step_Pa = 4e5;
        QCOMPARE(calibrationKind({}, recipe), TypedStep);
        recipe.shock = {};
        recipe.shock.enabled = false;
        QCOMPARE(calibrationKind({}, recipe), UnknownStep);
        recipe.input.treatment = ResponseTreatment::Impulse;
        QCOMPARE(calibrationKind({}, recipe), FreeDecay);
    }

    void names_areDistinct()
    {
        std::set<std::string> names;
        for (const CalibrationKind kind : {ComputedStep, TypedStep, UnknownStep, FreeDecay})
            names.insert(calibrationKindName(kind));
        QCOMPARE(names,
            (std::set<std::string>{"computed-step", "free-decay", "typed-step", "unknown-step"}));
    }
};

DYNCAL_TEST(TestCalibrationKind)
#include "tst_calibration_kind.moc"
