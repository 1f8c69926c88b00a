// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Sensor and front from the beginning of constructed records.

#include "core/realization/second_order/front_fit.h"
#include "tests/support/ramp_response.h"
#include "tests/support/simulated_calibration.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 400e3;
constexpr double kZeta = 0.7;
constexpr double kRate_Hz = 50e6;

/// Three records of steps 0.3, 0.6 and 0.9, which begin within the front.
std::vector<EarlyRecord> recordsOf(
    double front_s, double noise, std::uint64_t seed, double ar1 = 0.0)
{
    std::vector<EarlyRecord> records;
    for (int r = 0; r < 3; ++r) {
        RandomStream random(seed, r, 16);
        const double step = 0.3 * (r + 1);
        const double onset_s = 0.3 * front_s + 3e-9 * r;
        EarlyRecord record;
        record.rate_Hz = kRate_Hz;
        record.y = testing::simulatedNoise(random, 250, noise * step, ar1);
        for (Index k = 0; k < record.y.size(); ++k)
            record.y[k] += step
                * testing::rampResponse(
                    kF0_Hz, kZeta, front_s, static_cast<double>(k) / kRate_Hz - onset_s);
        record.weight = noise > 0.0 ? 1.0 / (noise * step * std::sqrt(1.0 - ar1 * ar1)) : 1.0;
        if (ar1 > 0.0)
            record.whitening = Eigen::VectorXd::Constant(1, -ar1);
        records.push_back(std::move(record));
    }
    return records;
}

const SecondOrderStart kStart{380e3, 0.65, {0.29, 0.62, 0.88}, {0.0, 0.0, 0.0}};

} // namespace

class TestFrontFit : public QObject
{
    Q_OBJECT

private slots:
    void withoutNoise_findsTheTruth()
    {
        for (const double front_s : {150e-9, 400e-9, 800e-9}) {
            const auto fit = fitFront(recordsOf(front_s, 0.0, 1), kStart, 200e-9, true);
            QVERIFY(fit);
            QVERIFY(std::abs(fit->duration_s / front_s - 1.0) < 1e-3);
            QVERIFY(std::abs(fit->f0_Hz / kF0_Hz - 1.0) < 1e-5);
            QVERIFY(std::abs(fit->zeta / kZeta - 1.0) < 1e-5);
        }
    }

    void given_isKept_andCostsMoreWhereItIsWrong()
    {
        const auto records = recordsOf(400e-9, 0.003, 5);
        const auto free = fitFront(records, kStart, 200e-9, true);
        const auto right = fitFront(records, kStart, 400e-9, false);
        const auto wrong = fitFront(records, kStart, 100e-9, false);
        QVERIFY(free && right && wrong);
        QCOMPARE(wrong->duration_s, 100e-9);
        QCOMPARE(wrong->u_duration_s, 0.0);
        QCOMPARE(free->parameters, right->parameters + 1);
        QVERIFY(free->cost <= right->cost);
        QVERIFY(right->cost - free->cost < 15.0); // chi square of one degree of freedom
        QVERIFY(wrong->cost - free->cost > 100.0);
    }

    void interval_data()
    {
        QTest::addColumn<double>("ar1");
        QTest::newRow("white") << 0.0;
        QTest::newRow("AR(0.9)") << 0.9;
    }
    /// Seeds 1 to n: duration within 1.96 u in 95 %, and costs as chi square.
    void interval()
    {
        QFETCH(double, ar1);
        const int runs = trials::count(60, 1000);
        int inside = 0;
        double costs = 0.0;
        for (int seed = 1; seed <= runs; ++seed) {
            const auto records = recordsOf(400e-9, 0.003, static_cast<std::uint64_t>(seed), ar1);
            const auto fit = fitFront(records, kStart, 200e-9, true);
            QVERIFY(fit);
            inside += std::abs(fit->duration_s - 400e-9) <= 1.96 * fit->u_duration_s;
            const double samples = 3.0 * (ar1 > 0.0 ? 249.0 : 250.0);
            costs += fit->cost / (samples - static_cast<double>(fit->parameters));
        }
        const double share = static_cast<double>(inside) / runs;
        QVERIFY2(share >= (runs > 100 ? 0.93 : 0.87) && share <= (runs > 100 ? 0.97 : 1.0),
            qPrintable(QString::number(share)));
        QVERIFY(std::abs(costs / runs - 1.0) < 0.02);
    }

    void whitenedSquares_areThoseOfTheInnovations()
    {
        EarlyRecord record;
        record.weight = 2.0;
        record.whitening = Eigen::VectorXd::Constant(1, -0.5);
        const Eigen::Vector3d residual(1.0, 2.0, 4.0);
        QCOMPARE(whitenedSquares(record, residual), 4.0 * (1.5 * 1.5 + 3.0 * 3.0));
    }
};

DYNCAL_TEST(TestFrontFit)
#include "tst_front_fit.moc"
