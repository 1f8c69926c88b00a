// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a front that nobody stated is told, and a sharp step is not.

#include "core/realization/model/unstated_front.h"
#include "tests/support/front_shots.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

Findings found(const ModelInput &input, Index order = 2, const RealizationSettings &settings = {})
{
    const auto hankel = decomposeHankel(input, settings);
    const auto result = testing::realizeModel(input, *hankel, order, settings);
    return result ? judgeUnstatedFront(input, result->model, result->assessment.poles) : Findings{};
}

int toldOf(int runs, double zeta, double front_s, Index order = 2)
{
    int told = 0;
    for (int seed = 1; seed <= runs; ++seed)
        told += !found(
            testing::shotsBehindFront(400e3, zeta, front_s, static_cast<std::uint64_t>(seed)),
            order)
                     .empty();
    return told;
}

} // namespace

class TestUnstatedFront : public QObject
{
    Q_OBJECT

private slots:
    void aFront_isTold_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("front_ns");
        QTest::addColumn<int>("order");
        QTest::newRow("250 ns") << 0.7 << 250.0 << 2;
        QTest::newRow("350 ns") << 0.7 << 350.0 << 2;
        QTest::newRow("600 ns") << 0.7 << 600.0 << 2;
        QTest::newRow("600 ns, taken for a real pole") << 0.7 << 600.0 << 3;
        QTest::newRow("damping 0.3") << 0.3 << 300.0 << 2;
        QTest::newRow("damping 0.95") << 0.95 << 400.0 << 2;
    }
    void aFront_isTold()
    {
        QFETCH(double, zeta);
        QFETCH(double, front_ns);
        QFETCH(int, order);
        const int runs = trials::count(5, 200);
        const int told = toldOf(runs, zeta, front_ns * 1e-9, order);
        QVERIFY2(told >= 0.95 * runs, qPrintable(QString::number(told)));
    }

    void itsDuration_isStated()
    {
        const Findings one = found(testing::shotsBehindFront(400e3, 0.7, 500e-9, 4));
        QCOMPARE(one.size(), std::size_t(1));
        QCOMPARE(one[0].id, std::string("MOD-019"));
        QCOMPARE(one[0].severity, Severity::Caution);
        const std::vector causes{FindingCause::Front, FindingCause::Order};
        QCOMPARE(one[0].causes, causes);
        const double told_ns = std::stod(one[0].message.arguments[2]);
        QVERIFY2(std::abs(told_ns - 500.0) < 20.0, one[0].message.arguments[2].c_str());
    }

    void what_isNotTold_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("front_ns");
        for (const double zeta : {0.02, 0.3, 0.7, 0.95, 1.5})
            QTest::addRow("sharp, zeta %g", zeta) << zeta << 0.0;
        QTest::newRow("as long as is allowed for") << 0.7 << 100.0;
    }
    /// One of 1e4 by chance.
    void what_isNotTold()
    {
        QFETCH(double, zeta);
        QFETCH(double, front_ns);
        const int runs = trials::count(10, 1000);
        const int told = toldOf(runs, zeta, front_ns * 1e-9);
        QVERIFY2(told <= (runs == 10 ? 0 : 2), qPrintable(QString::number(told)));
    }

    /// A second mode is no front: the model has it.
    void twoModes_areNot()
    {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const ModelInput input = testing::dampedShots(
                [](std::size_t, double t_s) {
                    return 0.9 * testing::dampedStep(200e3, 0.1, t_s)
                        + 0.1 * testing::dampedStep(700e3, 0.1, t_s);
                },
                seed, {0.003, 0.0, 50e6, 2000, 2000});
            QVERIFY(found(input, 4).empty());
        }
    }

    /// A recorder's own filter spreads a step over some of its samples.
    void threeSamples_areNoFront()
    {
        const testing::DampedShots slow{0.003, 0.0, 5e6, 200, 2000};
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            QVERIFY(found(testing::shotsBehindFront(400e3, 0.7, 500e-9, seed, slow)).empty());
    }

    /// 2500 samples to a period: means of twelve look like a front of their own, which is taken
    /// off.
    void slowSensor_isAskedByMeans()
    {
        const testing::DampedShots fast{0.003, 0.0, 50e6, 12000, 2000};
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Findings one = found(testing::shotsBehindFront(20e3, 0.7, 6e-6, seed, fast));
            QCOMPARE(one.size(), std::size_t(1));
            const double told_us = std::stod(one[0].message.arguments[2]);
            QVERIFY2(std::abs(told_us - 6.0) < 0.2, one[0].message.arguments[2].c_str());
            QVERIFY(found(testing::shotsBehindFront(20e3, 0.7, 0.0, seed, fast)).empty());
        }
    }

    void coloured_isStillTold()
    {
        const testing::DampedShots coloured{0.003, 0.9, 50e6, 600, 4000};
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            QVERIFY(!found(testing::shotsBehindFront(400e3, 0.7, 500e-9, seed, coloured)).empty());
            QVERIFY(found(testing::shotsBehindFront(400e3, 0.7, 0.0, seed, coloured)).empty());
        }
    }

    void stated_isNoNews()
    {
        ModelInput stated = testing::shotsBehindFront(400e3, 0.7, 600e-9, 1);
        stated.front.u_s = 1e-9;
        QVERIFY(found(stated).empty());
        stated.front = {600e-9, 0.0};
        QVERIFY(found(stated).empty());
    }

    void withoutRefinement_itIsToldToo()
    {
        RealizationSettings settings;
        settings.refine = false;
        QVERIFY(!found(testing::shotsBehindFront(400e3, 0.7, 600e-9, 1), 2, settings).empty());
    }
};

DYNCAL_TEST(TestUnstatedFront)
#include "tst_unstated_front.moc"
