// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/shot_combination.h"
#include "tests/support/order_trials.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;

/// Three shots of one sensor whose arrivals lie at the same place between two samples.
ModelInput alikeShots(double ar1, double noise, std::uint64_t seed, double zetaOfLast = 0.05)
{
    std::vector<ModelSeries> series;
    for (Index shot = 0; shot < 3; ++shot) {
        RandomStream random(seed, shot, 3);
        const double step = 0.3 * static_cast<double>(shot + 1);
        const auto draw = [&](Index count) {
            return testing::simulatedNoise(random, count, noise * step, ar1);
        };
        const Eigen::VectorXd before = draw(1000);
        const Eigen::VectorXd y
            = step * testing::sampledStep(30e3, shot == 2 ? zetaOfLast : 0.05, kRate_Hz, 400)
            + draw(400);
        series.push_back(testing::makeSeries(shot + 1, y, kRate_Hz, before));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(series));
}

double sdOf(const Eigen::VectorXd &x)
{
    return std::sqrt((x.array() - x.mean()).square().mean());
}

} // namespace

class TestOrderSuggestion : public QObject
{
    Q_OBJECT

private slots:
    void trials_giveTheTrueOrder_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < testing::orderTrials().size(); ++i)
            QTest::newRow(testing::orderTrials()[i].name.c_str()) << static_cast<int>(i);
    }
    void trials_giveTheTrueOrder()
    {
        // The full table: tests/accuracy/order_trials (docs/accuracy.md).
        constexpr int kTrials = 20;
        QFETCH(int, row);
        const testing::OrderTrial trial = testing::orderTrials()[static_cast<std::size_t>(row)];
        auto orders = testing::suggestedOrders(trial, kTrials);
        qInfo("%d of %d right", orders[trial.trueOrder], kTrials);
        QVERIFY(orders[trial.trueOrder] >= kTrials - 1);
    }

    void alikeShots_areCombined_nineTimesOutOfTen()
    {
        // The test is at 1 %: of 100, seven or more refusals have a probability of 1e-4.
        for (const double ar1 : {0.0, 0.9}) {
            int combined = 0;
            for (std::uint64_t seed = 1; seed <= 100; ++seed)
                combined += combineShots(alikeShots(ar1, 0.03, seed)).has_value();
            qInfo("AR(%.1f): %d of 100 combined", ar1, combined);
            QVERIFY(combined >= 94);
        }
    }

    void combination_isTheSensorWithLessNoise()
    {
        const ModelInput input = alikeShots(0.0, 0.03, 5);
        const auto mean = combineShots(input);
        QVERIFY(mean.has_value());
        const Eigen::VectorXd truth = testing::sampledStep(30e3, 0.05, kRate_Hz, 400);
        const double height = mean->y.mean() / truth.mean();
        // Equal noise relative to the step: the mean has 1/sqrt(3) of it; 400 values: 3.5 %.
        const double noise = sdOf(mean->y / height - truth);
        QVERIFY2(std::abs(noise / (0.03 / std::sqrt(3.0)) - 1.0) < 0.15,
            qPrintable(QString::number(noise)));
        QVERIFY(std::abs(mean->noiseSd / height / noise - 1.0) < 0.15);
        QCOMPARE(mean->noise.size(), Index(1000));
    }

    void shotOfAnotherShape_isNotCombined()
    {
        QVERIFY(combineShots(alikeShots(0.0, 0.01, 2)).has_value());
        QVERIFY(!combineShots(alikeShots(0.0, 0.01, 2, 0.1)));
        QVERIFY(!combineShots(alikeShots(0.9, 0.01, 2, 0.1)));
    }

    void shapesThatDiffer_stillGiveTheOrder()
    {
        const ModelInput input = alikeShots(0.9, 0.01, 4, 0.1);
        const auto hankel = decomposeHankel(input, {});
        // Two sensors ring in these shots, which is what the stack must find.
        QCOMPARE(suggestOrder(input, *hankel).order, Index(4));
    }

    void withoutNoiseRecord_nothingIsCombined()
    {
        ModelInput input = alikeShots(0.0, 0.03, 5);
        input.series[1].noise.resize(10);
        QVERIFY(!combineShots(input));
        input = alikeShots(0.0, 0.03, 5);
        input.series[1].noiseSd = 0.0;
        QVERIFY(!combineShots(input));
        input = alikeShots(0.0, 0.03, 5);
        input.series.resize(1);
        QVERIFY(!combineShots(input));
        input.series.clear();
        QVERIFY(!combineShots(input));
    }

    void flatRecord_isNotCombined()
    {
        ModelInput input = alikeShots(0.0, 0.03, 5);
        input.series[0].y.setZero();
        QVERIFY(!combineShots(input));
        for (ModelSeries &series : input.series)
            series.y.setZero();
        QVERIFY(!combineShots(input));
    }

    void noisyNoise_ofOneShot_weighsLess()
    {
        ModelInput input = alikeShots(0.0, 0.01, 7);
        RandomStream random(9, 1, 1);
        const Eigen::VectorXd much = testing::simulatedNoise(random, 1400, 0.3, 0.0);
        input.series[0].y += much.tail(400);
        input.series[0].noise = much.head(1000);
        input.series[0].noiseSd = sdOf(much.head(1000));
        const auto mean = combineShots(input);
        QVERIFY(mean.has_value());
        // Two shots of 1 % each remain.
        const double relative = mean->noiseSd / mean->y.tail(100).mean();
        QVERIFY2(std::abs(relative * std::sqrt(2.0) / 0.01 - 1.0) < 0.1,
            qPrintable(QString::number(relative)));
    }

    void everyTreatment_suggestsSomethingServed()
    {
        for (const ResponseTreatment treatment :
            {ResponseTreatment::StepDeflated, ResponseTreatment::StepAsImpulse,
                ResponseTreatment::Differenced, ResponseTreatment::Impulse}) {
            for (const double ar1 : {0.0, 0.9}) {
                ModelInput input = alikeShots(ar1, 0.01, 3);
                input.treatment = treatment;
                if (treatment == ResponseTreatment::StepAsImpulse)
                    input.series.resize(1);
                const auto hankel = decomposeHankel(input, {});
                const OrderSuggestion suggestion = suggestOrder(input, *hankel);
                QVERIFY(suggestion.order >= 1 && suggestion.order <= 20);
                QVERIFY(suggestion.bic.allFinite());
            }
        }
    }
};

DYNCAL_TEST(TestOrderSuggestion)
#include "tst_order_suggestion.moc"
