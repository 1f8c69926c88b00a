// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// U with another number of shots: closed forms, and calibrations with that many shots.

#include "core/model_analysis/shot_sensitivity.h"
#include "core/pipeline/pipeline.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "core/uncertainty/budgets.h"
#include "core/uncertainty/more_shots.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

bool isEqual(double found, double expected, double relative = 1e-12)
{
    return std::abs(found - expected) <= relative * std::abs(expected);
}

/// The mean of n shots, each with a u of 6 and five degrees of freedom, and a shared 2.
ReportedValue meanOfShots(Index n)
{
    ReportedValue reported{"sensitivity", 100.0, "V/Pa", {directLine("t1_k", 2.0)}};
    for (Index shot = 1; shot <= n; ++shot)
        reported.lines.push_back(
            with(OverShots::Own, directLine("level", 6.0 / static_cast<double>(n), 5.0)));
    combineLines(reported);
    return reported;
}

ReportedValue withScatter(Index n)
{
    const auto count = static_cast<double>(n);
    ReportedValue reported{"sensitivity", 100.0, "V/Pa",
        {directLine("t1_k", 2.0),
            with(OverShots::Scatter,
                directLine(kScatterOfShots, 6.0 / std::sqrt(count), count - 1.0))}};
    combineLines(reported);
    return reported;
}

void sameU(const ReportedValue &found, const ReportedValue &expected)
{
    QVERIFY(isEqual(*found.u, *expected.u));
    QVERIFY(isEqual(found.dof, expected.dof));
    QVERIFY(isEqual(found.k, expected.k));
}

} // namespace

class TestMoreShots : public QObject
{
    Q_OBJECT

private slots:
    /// Computed from 3 shots, and made of n shots outright: u, dof and k agree.
    void ownLines_areThoseOfThatManyShots()
    {
        for (Index n = 1; n <= 20; ++n) {
            const ReportedValue found = withShots(meanOfShots(3), 3, n);
            sameU(found, meanOfShots(n));
            QVERIFY(isEqual(*found.u, std::hypot(2.0, 6.0 / std::sqrt(static_cast<double>(n)))));
        }
    }

    void scatter_hasOneDegreeLessThanShots()
    {
        for (Index n = 2; n <= 20; ++n)
            sameU(withShots(withScatter(4), 4, n), withScatter(n));
        const ReportedValue alone = withShots(withScatter(4), 4, 1);
        QVERIFY(!alone.u && !alone.expanded());
        QVERIFY(std::isnan(alone.k));
    }

    void u_fallsToWhatIsShared()
    {
        const std::vector<ReportedValue> all = forShots(meanOfShots(3), 3);
        QCOMPARE(all.size(), std::size_t(20));
        for (std::size_t i = 1; i < all.size(); ++i)
            QVERIFY(*all[i].expanded() < *all[i - 1].expanded());
        const ReportedValue least = withEndlessShots(meanOfShots(3));
        QCOMPARE(*least.expanded(), 4.0);
        QVERIFY(*least.expanded() < *all.back().expanded());
    }

    void nothingShared_fallsToNothing()
    {
        ReportedValue reported{"x", 1.0, "", {with(OverShots::Own, directLine("noise", 1.0))}};
        combineLines(reported);
        QCOMPARE(*withEndlessShots(reported).u, 0.0);
        QCOMPARE(*withShots(reported, 1, 4).u, 0.5);
    }

    void withoutU_thereIsNothing()
    {
        ReportedValue reported = meanOfShots(2);
        reported.u.reset();
        QVERIFY(forShots(reported, 2).empty());
        QVERIFY(!withEndlessShots(reported).u);
        QVERIFY(!withShots(reported, 2, 3).u);
        QCOMPARE(*withShots(meanOfShots(2), 0, 3).u, *meanOfShots(2).u); // of none: as it is
    }

    /// Two shots are asked what four give: their own lines agree to the scatter of the noise's u.
    void simulatedShots_agree()
    {
        const auto budgetsOf = [](std::size_t shots) {
            SimulationSettings settings;
            settings.sensor = sensorPreset("optic3").value();
            settings.sampleRate_Hz = 2e7;
            settings.duration_s = 0.006;
            settings.noise = 0.1;
            settings.shots.assign(shots, ShotLevel::Medium);
            ResultCache cache;
            const auto set
                = std::make_shared<const CaptureSet>(simulateShots(settings).value().set);
            const auto results = runPipeline(set, {}, cache, StageId::Uncertainty).results;
            return allBudgets(*results.uncertainty, *results.response);
        };
        const std::vector<Budget> two = budgetsOf(2);
        const std::vector<Budget> four = budgetsOf(4);
        QCOMPARE(two.front().shots, Index(2));
        QCOMPARE(four.front().shots, Index(4));
        const ReportedValue expected = four.front().reported;
        const ReportedValue found = withShots(two.front().reported, 2, 4);
        QVERIFY(isEqual(*found.u, *expected.u, 0.02));
        double ownFound = 0.0;
        double ownExpected = 0.0;
        for (const UncertaintyLine &line : found.lines)
            ownFound += line.overShots == OverShots::Own ? std::pow(line.contribution, 2) : 0.0;
        for (const UncertaintyLine &line : expected.lines)
            ownExpected += line.overShots == OverShots::Own ? std::pow(line.contribution, 2) : 0.0;
        QVERIFY2(isEqual(ownFound, ownExpected, 0.2),
            qPrintable(QString("%1").arg(ownFound / ownExpected)));
        QVERIFY(isEqual(*withEndlessShots(two.front().reported).u,
            *withEndlessShots(four.front().reported).u, 0.02));
    }
};

DYNCAL_TEST(TestMoreShots)
#include "tst_more_shots.moc"
