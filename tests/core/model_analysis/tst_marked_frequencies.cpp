// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The rows of S(f) that are always there: the band's ends, its edges and the resonance.

#include "core/model_analysis/marked_frequencies.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/cascade_model.h"
#include "tests/support/near.h"
#include "tests/support/second_order_model.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using testing::isNear;

class TestMarkedFrequencies : public QObject
{
    Q_OBJECT

private:
    static std::shared_ptr<const ResponseResult> responseOf(const Recipe &recipe)
    {
        ResultCache cache;
        return runPipeline(testing::simulatedExample(2e7), recipe, cache, StageId::Response)
            .results.response;
    }

private slots:
    void peak_ofASecondOrderSensor_isThatOfItsFormula()
    {
        for (const double zeta : {0.02, 0.1, 0.4, 0.6}) {
            const SensorModel model = testing::secondOrderModel(300e3, zeta);
            const auto peak = resonancePeak(model, ResponseTreatment::StepDeflated, 300e3, zeta);
            QVERIFY(peak);
            QVERIFY(isNear(peak->frequency_Hz, 300e3 * std::sqrt(1.0 - 2.0 * zeta * zeta), 1e-6));
            QVERIFY(isNear(peak->gain, 0.5 / (zeta * std::sqrt(1.0 - zeta * zeta)), 1e-9));
        }
        const SensorModel damped = testing::secondOrderModel(300e3, 0.8);
        QVERIFY(!resonancePeak(damped, ResponseTreatment::StepDeflated, 300e3, 0.8));
    }

    /// |S| of both rises from 181 to 361 kHz, toward the second mode: the end of the search is no
    /// resonance of the first.
    void slopeOfAnotherMode_isNoPeak()
    {
        const SensorModel model = testing::cascadeModel({{300e3, 0.3}, {420e3, 0.02}});
        const auto first = resonancePeak(model, ResponseTreatment::StepDeflated, 300e3, 0.3);
        QVERIFY2(!first, qPrintable(QString::number(first ? first->frequency_Hz : 0.0)));
        const auto second = resonancePeak(model, ResponseTreatment::StepDeflated, 420e3, 0.02);
        QVERIFY(second && isNear(second->frequency_Hz, 420e3, 0.01));
    }

    void marks_areTheEndsTheEdgesAndTheResonance()
    {
        const auto response = responseOf({});
        QVERIFY(response->atMarks);
        const ResponseResult &marked = *response->atMarks;
        QCOMPARE(static_cast<Index>(marked.marks.size()), marked.frequency_Hz.size());
        QVERIFY(std::ranges::is_sorted(marked.frequency_Hz));
        QCOMPARE(marked.marks.front(), RowMark::LowEnd);
        QCOMPARE(marked.marks.back(), RowMark::HighEnd);
        QCOMPARE(marked.frequency_Hz[0], response->fLow_Hz);
        const auto at = std::ranges::find(marked.marks, RowMark::Within5percent);
        QVERIFY(at != marked.marks.end());
        QCOMPARE(marked.frequency_Hz[at - marked.marks.begin()],
            *response->characteristics.within5percent_Hz);
        QVERIFY(std::ranges::count(marked.marks, RowMark::Resonance) == 1);
    }

    /// What stands in a marked row is what the row would hold if the recipe asked for it.
    void markedRow_isTheRowOfItsFrequency()
    {
        const auto plain = responseOf({});
        const ResponseResult &marked = *plain->atMarks;
        Recipe recipe;
        recipe.response.grid = "list";
        recipe.response.frequencies_Hz.assign(
            marked.frequency_Hz.begin(), marked.frequency_Hz.end());
        const auto asked = responseOf(recipe);
        for (Index row = 0; row < marked.frequency_Hz.size(); ++row) {
            QCOMPARE(std::isfinite(marked.magnitude[row]), std::isfinite(asked->magnitude[row]));
            if (!std::isfinite(marked.magnitude[row]))
                continue;
            QCOMPARE(marked.magnitude[row], asked->magnitude[row]);
            QCOMPARE(marked.u_noiseMagnitude[row], asked->u_noiseMagnitude[row]);
            QCOMPARE(marked.phase_rad[row], asked->phase_rad[row]);
            QCOMPARE(marked.modelMagnitude[row], asked->modelMagnitude[row]);
        }
    }

    void freeDecay_hasNone()
    {
        Recipe recipe;
        recipe.input.treatment = ResponseTreatment::Impulse;
        const auto response = responseOf(recipe);
        QVERIFY(!response || !response->atMarks);
    }
};

DYNCAL_TEST(TestMarkedFrequencies)
#include "tst_marked_frequencies.moc"
