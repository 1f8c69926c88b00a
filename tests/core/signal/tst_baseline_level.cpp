// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The level of a baseline that stands, that drifts, and that only seems to.

#include "core/signal/baseline_level.h"
#include "tests/core/signal/window_records.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <random>

using namespace dyncal;
using testing::isNear;

namespace {

/// AR(1) noise of standard deviation 1, and more.
Eigen::VectorXd noise(
    Index samples, double memory, unsigned seed,
    const std::function<double(double)> &more = [](double) { return 0.0; })
{
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal(0.0, std::sqrt(1.0 - memory * memory));
    Eigen::VectorXd values(samples);
    double last = 0.0;
    for (Index i = 0; i < samples; ++i) {
        last = memory * last + normal(engine);
        values[i] = last + more(static_cast<double>(i));
    }
    return values;
}

} // namespace

class TestBaselineLevel : public QObject
{
    Q_OBJECT

private slots:
    void drift_isFollowedToTheStart()
    {
        constexpr Index kSamples = 4000, kAhead = 200;
        const auto drift = [](double t) { return 3.0 + 2e-3 * t; };
        const double atStart = drift(static_cast<double>(kSamples - 1 + kAhead));
        double sum = 0.0, squares = 0.0, factor = 0.0;
        const int trials = trials::count(300, 5000);
        for (int seed = 1; seed <= trials; ++seed) {
            const BaselineLevel found
                = baselineLevel(noise(kSamples, 0.0, static_cast<unsigned>(seed), drift), kAhead);
            factor = found.varianceFactor;
            sum += found.level - atStart;
            squares += std::pow(found.level - atStart, 2);
        }
        const double u = std::sqrt(factor / kSamples);
        QVERIFY(std::abs(sum / trials) < 4.0 * u / std::sqrt(trials));
        QVERIFY(isNear(std::sqrt(squares / trials), u, 4.0 / std::sqrt(2.0 * trials)));
    }

    void withoutNoise_theLineIsExact()
    {
        Eigen::VectorXd values(1000);
        for (Index i = 0; i < 1000; ++i)
            values[i] = 0.5 - 0.01 * static_cast<double>(i);
        QVERIFY(isNear(baselineLevel(values, 51).level, 0.5 - 0.01 * 1050.0, 1e-12));
        QCOMPARE(baselineLevel(Eigen::VectorXd::Constant(1000, 0.5), 51).level, 0.5);
        QCOMPARE(baselineLevel(Eigen::VectorXd::Constant(1000, 0.5), 51).varianceFactor, 1.0);
    }

    /// Noise, slow noise and hum stay with their mean.
    void whatIsNoDrift_hasItsMean_data()
    {
        QTest::addColumn<double>("memory");
        for (const double memory : {0.0, 0.9, 0.999})
            QTest::addRow("AR(%g)", memory) << memory;
    }
    void whatIsNoDrift_hasItsMean()
    {
        QFETCH(double, memory);
        const int trials = trials::count(500, 20000);
        int followed = 0;
        for (int seed = 1; seed <= trials; ++seed) {
            const Eigen::VectorXd values = noise(4000, memory, static_cast<unsigned>(seed));
            const BaselineLevel found = baselineLevel(values, 200);
            followed += found.varianceFactor > 1.0 ? 1 : 0;
            QVERIFY(found.varianceFactor > 1.0 || found.level == fitLine(values).mean);
        }
        QVERIFY2(followed <= 0.004 * trials, qPrintable(QString::number(followed)));
    }
    void hum_hasItsMean()
    {
        for (const double period : {500.0, 1700.0, 4000.0, 5000.0})
            for (double phase = 0.0; phase < 6.3; phase += 0.1) {
                const auto hum
                    = [&](double t) { return 20.0 * std::sin(6.2832 * t / period + phase); };
                QCOMPARE(baselineLevel(noise(4000, 0.0, 1, hum), 200).varianceFactor, 1.0);
            }
    }

    /// A step behind a drift is right, whatever its baseline has come from.
    void window_countsFromTheLevelAtTheStart()
    {
        constexpr double kRate_Hz = 2e5;
        const testing::StepRecord record = testing::stepRecord();
        for (const double drift_per_ms : {0.0, -0.001, 0.0003, 0.001}) {
            Eigen::VectorXd values = record.values();
            const double perSample = record.step * drift_per_ms * 1e3 / kRate_Hz;
            for (Index i = 0; i < 4000; ++i)
                values[i] += perSample * static_cast<double>(i - 4000);
            const auto result = testing::cut(testing::doubleChannel(values, kRate_Hz));
            const WindowedResponse &r = testing::only(result);
            QVERIFY2(
                std::abs(r.step / record.step - 1.0) < 2e-4, qPrintable(QString::number(r.step)));
            QCOMPARE(r.baselineVarianceFactor > 3.9, drift_per_ms != 0.0);
        }
    }

    void whereTheLineIsNoGuide_theMeanIsTaken()
    {
        const auto drift = [](double t) { return 1e-2 * t; };
        const Eigen::VectorXd values = noise(1000, 0.0, 1, drift);
        QVERIFY(baselineLevel(values, 1000).varianceFactor > 1.0);
        for (const Index ahead : {-1, 1001})
            QCOMPARE(baselineLevel(values, ahead).level, fitLine(values).mean);
        QCOMPARE(baselineLevel(values.head(127), 5).level, fitLine(values.head(127)).mean);
        QCOMPARE(baselineLevel(Eigen::VectorXd(), 5).level, 0.0);
    }
};

DYNCAL_TEST(TestBaselineLevel)
#include "tst_baseline_level.moc"
