// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The settling time jumps by half a wave where a swing just leaves the settled range: second-order
// sensors, whose swings are e^(-k pi zeta/sqrt(1 - zeta^2)), against the scatter of many
// calibrations.

#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/normalised_step.h"
#include "core/model_analysis/step_scan.h"
#include "core/uncertainty/model_noise.h"
#include "core/uncertainty/model_values.h"
#include "core/uncertainty/settling_spread.h"
#include "tests/support/damped_shots.h"
#include "tests/support/near.h"
#include "tests/support/realized_model.h"
#include "tests/support/stated_chain.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/support/wide_response.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kF0_Hz = 318e3;
constexpr ResponseTreatment kStep = ResponseTreatment::StepDeflated;

/// Whose k-th swing is `size` of the step.
double dampingOf(int k, double size)
{
    const double x = -std::log(size) / (k * std::numbers::pi);
    return x / std::sqrt(1.0 + x * x);
}

/// Last time at which the response is 5 % off, by bisection of the last change of a dense list.
double settlingOf(double zeta)
{
    constexpr double kStep_s = 1e-9;
    const auto isOut
        = [&](double t_s) { return std::abs(testing::dampedStep(kF0_Hz, zeta, t_s) - 1.0) > 0.05; };
    double out_s = 0.0;
    for (double t_s = 0.0; t_s < 60e-6; t_s += kStep_s)
        if (isOut(t_s))
            out_s = t_s;
    double in_s = out_s + kStep_s;
    for (int i = 0; i < 50; ++i) {
        const double middle_s = 0.5 * (out_s + in_s);
        (isOut(middle_s) ? out_s : in_s) = middle_s;
    }
    return out_s;
}

struct Made
{
    ModelInput input;
    testing::RealizedModel model;
    std::vector<ModelVariation> variations;
};

Made madeOf(double zeta, int seed, double noise)
{
    Made made{
        testing::dampedShots(kF0_Hz, zeta, static_cast<std::uint64_t>(seed), {noise}), {}, {}};
    made.model = *testing::realizeModel(made.input, *decomposeHankel(made.input, {}), 2);
    made.variations = modelVariations(made.input, made.model.model);
    return made;
}

double derivativeOf(const Made &made)
{
    return spreadOver(made.variations, [](const SensorModel &one) {
        return settlingTime_s(one, kStep, kSettledRange).value_or(0.0);
    });
}

double spreadOf(const Made &made, double wider = 1.0)
{
    return settlingSpread_s(
        made.model.model, made.variations, kStep, wider * derivativeOf(made), wider);
}

} // namespace

class TestSettlingSpread : public QObject
{
    Q_OBJECT

private slots:
    void settlingTime_isThatOfTheClosedForm_forEveryRange()
    {
        for (const double zeta : {0.05, 0.2, 0.7, 1.2}) {
            const Made made = madeOf(zeta, 1, 0.0);
            const auto found_s = settlingTime_s(made.model.model, kStep, kSettledRange);
            QVERIFY(found_s && isNear(*found_s, settlingOf(zeta), 1e-4));
            QVERIFY(*settlingTime_s(made.model.model, kStep, 0.02) > *found_s);
            QVERIFY(*settlingTime_s(made.model.model, kStep, 0.1) < *found_s);
        }
    }

    void noLaterValue_isFartherThanTheRest()
    {
        const Made made = madeOf(0.05, 1, 0.0);
        const ExponentialSum y = normalisedStep(made.model.model);
        for (double t_s = 0.0; t_s < 30e-6; t_s += 0.37e-6)
            for (double later_s = t_s; later_s < 40e-6; later_s += 0.1e-6)
                QVERIFY(std::abs(y.value(later_s) - 1.0) <= restAfter(y, t_s) + 1e-12);
    }

    void interval_holdsTheTruth_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::newRow("at a jump: fourth swing 5 %") << dampingOf(4, 0.05);
        QTest::newRow("just behind it: 5.05 %") << dampingOf(4, 0.0505);
        QTest::newRow("first swing 5.1 %") << dampingOf(1, 0.051);
        QTest::newRow("far from one") << dampingOf(4, 0.058);
        QTest::newRow("weakly damped") << 0.05;
        QTest::newRow("overdamped") << 1.2;
    }
    /// Of 40, 95 % each: fewer than 34 in one of three thousand.
    void interval_holdsTheTruth()
    {
        QFETCH(double, zeta);
        const int runs = trials::count(40, 1000);
        const double truth_s = settlingOf(zeta);
        int held = 0;
        for (int seed = 1; seed <= runs; ++seed) {
            const Made made = madeOf(zeta, seed, 0.005);
            const double found_s = *settlingTime_s(made.model.model, kStep, kSettledRange);
            held += std::abs(found_s - truth_s) <= 2.0 * spreadOf(made) ? 1 : 0;
        }
        qInfo("%d of %d", held, runs);
        QVERIFY(held >= (runs == 40 ? 34 : 0.93 * runs));
    }

    void farFromAJump_itIsTheDerivative_andTheScatter()
    {
        constexpr int kRuns = 40;
        const double zeta = dampingOf(4, 0.065);
        const double truth_s = settlingOf(zeta);
        double squares = 0.0;
        for (int seed = 1; seed <= kRuns; ++seed) {
            const Made made = madeOf(zeta, seed, 0.002);
            const double error_s
                = *settlingTime_s(made.model.model, kStep, kSettledRange) - truth_s;
            QCOMPARE(spreadOf(made), derivativeOf(made));
            squares += std::pow(error_s / spreadOf(made), 2) / kRuns;
        }
        qInfo("%.2f", squares);
        QVERIFY(squares > 0.5 && squares < 1.7); // 99.9 % of chi square over 40
    }

    /// From where the third swing (10.6 %) enters the range, 62 degrees behind its top, to the top
    /// of the fourth: 118 of 180 degrees, half of which counts as u.
    void nearAJump_itIsInU()
    {
        const double half_s = 0.5 / kF0_Hz;
        const Made made = madeOf(dampingOf(4, 0.0502), 3, 0.005);
        QVERIFY(spreadOf(made) > 0.3 * half_s && spreadOf(made) < 0.4 * half_s);
        QVERIFY(spreadOf(madeOf(dampingOf(4, 0.0502), 3, 1e-5)) < 0.1 * half_s);
    }

    void widerScatter_reachesFarther()
    {
        const Made made = madeOf(dampingOf(4, 0.065), 3, 0.001);
        QVERIFY(isNear(spreadOf(made, 2.0), 2.0 * spreadOf(made)));
        QVERIFY(spreadOf(made, 40.0) > 10.0 * spreadOf(made));
    }

    void budget_hasIt()
    {
        const Made made = madeOf(dampingOf(4, 0.0502), 3, 0.005);
        const auto values = modelValues(made.model.model, made.model.assessment,
            testing::wideOpen(made.model.model), made.variations, kStep, testing::statedChain());
        const auto found
            = std::ranges::find(values, std::string("settling_time_s"), &ReportedValue::of);
        QVERIFY(found != values.end());
        QCOMPARE(found->lines.front().quantity, std::string("noise"));
        QVERIFY(isNear(found->lines.front().u, spreadOf(made), 0.05));
    }

    void withoutVariations_itIsNotKnown()
    {
        Made made = madeOf(0.2, 1, 0.005);
        made.variations.clear();
        QVERIFY(std::isnan(spreadOf(made)));
        made = madeOf(0.2, 1, 0.005);
        QVERIFY(std::isnan(settlingSpread_s(
            made.model.model, made.variations, ResponseTreatment::Impulse, 1e-6, 1.0)));
    }
};

DYNCAL_TEST(TestSettlingSpread)
#include "tst_settling_spread.moc"
