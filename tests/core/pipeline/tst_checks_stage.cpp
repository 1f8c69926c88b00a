// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_table.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

namespace {

using C = FindingCause;

const std::shared_ptr<const CaptureSet> &example()
{
    static const auto set = testing::simulatedExample(1e7, 0.006);
    return set;
}

CalibrationResults resultsOf(const std::shared_ptr<const CaptureSet> &set, const Recipe &recipe)
{
    ResultCache cache;
    return runPipeline(set, recipe, cache, StageId::Checks).results;
}

CalibrationResults resultsOf(const Recipe &recipe = {})
{
    return resultsOf(example(), recipe);
}

bool names(const Findings &findings, C cause)
{
    return std::ranges::any_of(findings, [&](const Finding &finding) {
        return finding.severity != Severity::Info
            && std::ranges::find(finding.causes, cause) != finding.causes.end();
    });
}

int countOf(const CalibrationResults &results, Compared of)
{
    return static_cast<int>(std::ranges::count_if(results.checks->checks,
        [&](const WayComparison &check) { return check.of == of && check.isMade(); }));
}

} // namespace

class TestChecksStage : public QObject
{
    Q_OBJECT

private slots:
    void example_everythingAgrees();
    void everyComparison_hasUOrAReason();
    void wrongTemperature_isFound();
    void wrongPressure_isFound();
    void typedVelocity_isComparedWithTheArrivals();
    void stateFromAPressure_isComparedWithTheRecords_data();
    void stateFromAPressure_isComparedWithTheRecords();
    void stateFromAPressure_ofOneShot_isCautioned();
    void rateDoubled_isFoundOrBlocked();
    void scaleOfTheCard_isFound();
    void switchedOff_nothingIsCompared();
};

void TestChecksStage::example_everythingAgrees()
{
    const CalibrationResults results = resultsOf();
    QVERIFY(results.checks);
    for (const WayComparison &check : results.checks->checks)
        QVERIFY2(check.agrees(),
            qPrintable(QString("%1 by %2: %3 u")
                           .arg(comparedName(check.of), wayName(check.a))
                           .arg(check.difference() / check.u)));
    QVERIFY(results.checks->findings.empty());
    // Three shots with one side sensor each: two Mach numbers, p2, p5, p4 and the card.
    QCOMPARE(countOf(results, Compared::Mach), 6);
    QCOMPARE(countOf(results, Compared::P2Rise), 3);
    QCOMPARE(countOf(results, Compared::P5Rise), 3);
    QCOMPARE(countOf(results, Compared::P4), 3);
    QCOMPARE(countOf(results, Compared::Sensitivity), 3);
    QCOMPARE(countOf(results, Compared::Levels), 1);
    QCOMPARE(countOf(results, Compared::Shots), 1);
}

void TestChecksStage::everyComparison_hasUOrAReason()
{
    const CalibrationResults results = resultsOf();
    for (const WayComparison &check : results.checks->checks) {
        if (!check.isMade())
            QVERIFY(!english(*check.missing).empty());
        else if (check.of != Compared::Levels)
            QVERIFY2(check.u > 0.0 && std::isfinite(check.u) && std::isfinite(check.difference()),
                comparedName(check.of));
    }
}

void TestChecksStage::wrongTemperature_isFound()
{
    Recipe recipe;
    recipe.shock.T1_K = 294.15 + 15.0;
    const CalibrationResults results = resultsOf(recipe);
    QVERIFY(names(results.checks->findings, C::Temperature));
    QVERIFY(!names(results.checks->findings, C::Pressure));
}

void TestChecksStage::wrongPressure_isFound()
{
    Recipe recipe;
    recipe.shock.p1_Pa = 101100.0 * 1.12;
    const CalibrationResults results = resultsOf(recipe);
    QVERIFY(names(results.checks->findings, C::Pressure));
    QVERIFY(!names(results.checks->findings, C::Temperature));
}

void TestChecksStage::typedVelocity_isComparedWithTheArrivals()
{
    Recipe recipe;
    recipe.shock.velocity_m_s = 512.8;
    const CalibrationResults once = resultsOf(recipe);
    QCOMPARE(countOf(once, Compared::Velocity), 3);
    QVERIFY(names(once.checks->findings, C::Typed));
    QVERIFY(names(once.shock->findings, C::Typed)); // SHK-018
    QCOMPARE(worstSeverity(once.checks->findings), Severity::Block);
    // What the arrivals give, typed shot by shot, contradicts nothing.
    const CalibrationResults measured = resultsOf();
    recipe.shock.velocity_m_s = PerShot();
    for (const ShockConditions &shot : measured.shock->shots)
        recipe.shock.velocity_m_s.each.push_back(shot.states->velocity_m_s);
    const CalibrationResults listed = resultsOf(recipe);
    QVERIFY(listed.checks->findings.empty());
    QVERIFY(!names(listed.shock->findings, C::Typed));
    recipe.shock.velocity_m_s.each[1] = 1.04 * *recipe.shock.velocity_m_s.each[1];
    const CalibrationResults misread = resultsOf(recipe);
    QVERIFY(names(misread.checks->findings, C::Typed));
    for (const Finding &finding : misread.checks->findings)
        QVERIFY(finding.shot == 2 && finding.severity == Severity::Caution);
}

void TestChecksStage::stateFromAPressure_isComparedWithTheRecords_data()
{
    QTest::addColumn<bool>("fromP2");
    QTest::newRow("p2") << true;
    QTest::newRow("p4") << false;
}

/// One pressure for three shots of different strength: right for one of them at most.
void TestChecksStage::stateFromAPressure_isComparedWithTheRecords()
{
    QFETCH(bool, fromP2);
    const ShockConditions strongest = resultsOf().shock->shots[2];
    Recipe recipe;
    recipe.shock.stateFrom = fromP2 ? "p2" : "p4";
    (fromP2 ? recipe.shock.p2_Pa : recipe.shock.p4_Pa)
        = fromP2 ? strongest.states->shocked.pressure_Pa : strongest.driver->pressure_Pa;
    const CalibrationResults results = resultsOf(recipe);
    QCOMPARE(countOf(results, Compared::Velocity), 3);
    QCOMPARE(countOf(results, Compared::P2Rise), 3);
    QCOMPARE(countOf(results, Compared::Sensitivity), 3);
    QCOMPARE(countOf(results, Compared::P4), fromP2 ? 3 : 0); // no second way to itself
    QVERIFY(names(results.shock->findings, C::Typed)); // SHK-018
    QVERIFY(names(results.checks->findings, C::Typed));
    QCOMPARE(worstSeverity(results.checks->findings), Severity::Block);
    for (const WayComparison &check : results.checks->checks)
        if (check.of == Compared::Velocity)
            QCOMPARE(check.agrees(), check.shot == 3); // the pressure was that of shot 3
    for (const ShockConditions &shot : results.shock->shots)
        QVERIFY(!shot.uncertainty && shot.uncertaintyMissing.has_value());
}

/// A gauge pressure where an absolute one is asked for.
void TestChecksStage::stateFromAPressure_ofOneShot_isCautioned()
{
    const ShockConditions strongest = resultsOf().shock->shots[2];
    Recipe recipe;
    recipe.import.exclude = {{1, "other"}, {2, "other"}};
    recipe.shock.stateFrom = "p2";
    recipe.shock.p2_Pa = strongest.states->shocked.pressure_Pa;
    const CalibrationResults right = resultsOf(recipe);
    QVERIFY(right.checks->findings.empty());
    QVERIFY(!names(right.shock->findings, C::Typed));
    recipe.shock.p2_Pa = *recipe.shock.p2_Pa - 101100.0;
    const CalibrationResults gauge = resultsOf(recipe);
    QVERIFY(names(gauge.checks->findings, C::Typed));
    QCOMPARE(worstSeverity(gauge.checks->findings), Severity::Caution);
}

void TestChecksStage::rateDoubled_isFoundOrBlocked()
{
    auto fast = std::make_shared<CaptureSet>(*example());
    for (Shot &shot : fast->shots)
        for (Channel &channel : shot.channels) {
            channel.sampleRate_Hz *= 2.0;
            channel.t0_s /= 2.0;
        }
    const CalibrationResults results = resultsOf(fast, {});
    QVERIFY(results.shock && names(results.shock->findings, C::Rate)); // SHK-019
    QCOMPARE(worstSeverity(results.shock->findings), Severity::Block);
}

void TestChecksStage::scaleOfTheCard_isFound()
{
    Recipe recipe;
    recipe.import.scale = 1000.0;
    const CalibrationResults results = resultsOf(recipe);
    QVERIFY(names(results.checks->findings, C::Scale));
    QVERIFY(!names(results.checks->findings, C::Pressure));
}

void TestChecksStage::switchedOff_nothingIsCompared()
{
    Recipe recipe;
    recipe.shock.enabled = false;
    QVERIFY(resultsOf(recipe).checks->checks.empty());
}

DYNCAL_TEST(TestChecksStage)
#include "tst_checks_stage.moc"
