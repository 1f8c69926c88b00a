// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/consistency_findings.h"

#include "core/base/number_text.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using C = FindingCause;

Findings judged(const MadeComparison &made, const ShockSettings &settings = {})
{
    return judgeConsistency(*made.compared, made.compared->comparisons(), settings);
}

/// Three shots of which the second one has the fault.
std::vector<MadeShot> secondWith(const std::function<void(MadeShot &)> &fault)
{
    std::vector<MadeShot> shots{
        {.velocity_m_s = 420.0}, {.velocity_m_s = 470.0}, {.velocity_m_s = 512.8}};
    fault(shots[1]);
    return shots;
}

const Finding *findingOf(const Findings &findings, const char *id)
{
    const auto found = std::ranges::find(findings, std::string(id), &Finding::id);
    return found != findings.end() ? &*found : nullptr;
}

bool names(const Finding &finding, C cause)
{
    return std::ranges::find(finding.causes, cause) != finding.causes.end();
}

double sizeOf(const WayComparison &check)
{
    return std::abs(check.difference() / check.u);
}

/// The comparison that differs most among those of a shot and some quantities.
const WayComparison &worstOf(
    const MadeComparison &made, Index shot, const std::vector<Compared> &quantities)
{
    const WayComparison *worst = nullptr;
    for (const WayComparison &check : made.compared->comparisons()) {
        const bool counts = check.isMade() && check.shot == shot
            && std::ranges::find(quantities, check.of) != quantities.end();
        if (counts && (worst == nullptr || sizeOf(check) > sizeOf(*worst)))
            worst = &check;
    }
    return *worst;
}

/// What every finding of one comparison says of it.
void compareWithItsNumbers(const Finding &finding, const WayComparison &check)
{
    QCOMPARE(finding.shot, check.shot);
    QCOMPARE(finding.channel, check.channel);
    QCOMPARE(*finding.value, check.difference() / check.u);
    QCOMPARE(*finding.limit, kContradiction);
    QVERIFY(std::abs(*finding.value) > kContradiction);
    QCOMPARE(finding.message.arguments.at(0), numberWithUnit(check.value_a, check.unit, 4));
    QCOMPARE(finding.message.arguments.at(1), numberWithUnit(check.value_b, check.unit, 4));
    QCOMPARE(finding.message.arguments.at(2), numberText(sizeOf(check), 2));
    const std::string told = english(finding.message);
    QVERIFY(told.find('%') == std::string::npos);
    QVERIFY(told.find(finding.message.arguments[0]) != std::string::npos);
    QVERIFY(told.find(check.channel) != std::string::npos);
}

/// Twelve shots, none of whose sensitivities contradicts the card, but which scatter much more than
/// the levels do.
MadeComparison scatteredShots()
{
    std::vector<MadeShot> shots;
    for (int i = 0; i < 12; ++i)
        shots.push_back({.velocity_m_s = 450.0 + 5.0 * i,
            .places_m = {0.8},
            .dutGain = i % 2 == 0 ? 1.006 : 1.0 / 1.006});
    return MadeComparison(shots);
}

} // namespace

class TestConsistencyFindings : public QObject
{
    Q_OBJECT

private slots:
    void oneShotWrong_isTheOneThatIsTold_data();
    void oneShotWrong_isTheOneThatIsTold();
    void worseOfTheRatios_isTold();
    void textNamesTheRatio();
    void typedStep_blocksWhereOneServesSeveral();
    void oneShotAlone_doesNotBlock();
    void counters_neverBlock();
    void whatOthersSay_isNotSaidAgain_data();
    void whatOthersSay_isNotSaidAgain();
    void unexplained_namesAllThatActs_data();
    void unexplained_namesAllThatActs();
    void wrongOrder_concernsNoSingleShot();
    void scatterWithoutAnyContradiction_isTold();
    void scatterOfWhatWasTyped_namesIt();
    void scatterOfTheShots_isTheirs();
    void chanceBeyondCounting_hasABound();
    void contradictionAlone_isNotToldTwice();
    void nothingWrong_nothingTold();
};

void TestConsistencyFindings::oneShotWrong_isTheOneThatIsTold_data()
{
    QTest::addColumn<std::function<void(MadeShot &)>>("fault");
    QTest::addColumn<QString>("id");
    QTest::addColumn<std::vector<Compared>>("quantities");
    QTest::addColumn<C>("cause");
    using Fault = std::function<void(MadeShot &)>;
    using Q = std::vector<Compared>;
    QTest::newRow("temperature") << Fault([](MadeShot &s) { s.trueT1_K += 25.0; }) << "CHK-001"
                                 << Q{Compared::Mach} << C::Temperature;
    QTest::newRow("typed velocity") << Fault([](MadeShot &s) { s.typedVelocity_m_s = 500.0; })
                                    << "CHK-002" << Q{Compared::Velocity} << C::Typed;
    QTest::newRow("side sensors") << Fault([](MadeShot &s) { s.sideGain = 1.2; }) << "SHK-002"
                                  << Q{Compared::P2Rise, Compared::P5Rise} << C::Scale;
    QTest::newRow("scale of the DUT") << Fault([](MadeShot &s) { s.dutGain = 1.1; }) << "CHK-003"
                                      << Q{Compared::Sensitivity} << C::Scale;
}

void TestConsistencyFindings::oneShotWrong_isTheOneThatIsTold()
{
    QFETCH(std::function<void(MadeShot &)>, fault);
    QFETCH(QString, id);
    QFETCH(std::vector<Compared>, quantities);
    QFETCH(C, cause);
    const MadeComparison made(secondWith(fault));
    const Findings findings = judged(made);
    const Finding *told = findingOf(findings, id.toLatin1().constData());
    QVERIFY(told != nullptr);
    QCOMPARE(told->severity, Severity::Caution);
    compareWithItsNumbers(*told, worstOf(made, 2, quantities));
    QVERIFY(names(*told, cause));
    for (const Finding &finding : findings) {
        QCOMPARE(finding.shot, Index(2));
        QVERIFY(finding.id != "CHK-005" && finding.id != "CHK-004");
    }
}

void TestConsistencyFindings::worseOfTheRatios_isTold()
{
    const MadeComparison made(secondWith([](MadeShot &shot) { shot.timeFactor = 0.9; }));
    const Findings findings = judged(made);
    QCOMPARE(std::ranges::count(findings, std::string("CHK-001"), &Finding::id), 1);
    compareWithItsNumbers(*findingOf(findings, "CHK-001"), worstOf(made, 2, {Compared::Mach}));
    QVERIFY(*findingOf(findings, "CHK-001")->value < 0.0); // too fast by the clock
}

void TestConsistencyFindings::textNamesTheRatio()
{
    // Of two ratios that both contradict, the text speaks of the one whose numbers it tells.
    WayComparison check{.of = Compared::Mach,
        .a = Way::StepRatio,
        .b = Way::SoundSpeed,
        .shot = 1,
        .channel = "side 7",
        .value_a = 1.5,
        .value_b = 1.4,
        .u = 0.01,
        .unit = "1"};
    const MadeComparison made(std::vector<MadeShot>(1));
    std::string texts[2];
    for (const Way way : {Way::StepRatio, Way::VelocityRatio}) {
        check.a = way;
        const Findings told = judgeConsistency(*made.compared, {check}, {});
        QCOMPARE(told.size(), std::size_t(1));
        compareWithItsNumbers(told[0], check);
        texts[way == Way::VelocityRatio] = english(told[0].message);
    }
    QVERIFY(texts[0].find("incident step") != std::string::npos);
    QVERIFY(texts[1].find("velocities") != std::string::npos);
}

void TestConsistencyFindings::typedStep_blocksWhereOneServesSeveral()
{
    std::vector<ShotEvidence> evidence;
    for (const double velocity : {480.0, 512.8}) {
        evidence.push_back(madeEvidence({.velocity_m_s = velocity}, std::ssize(evidence) + 1));
        evidence.back().typedStep_Pa = evidence.back().measurement->typedStep_Pa
            = evidence.back().step_Pa = 1e5;
        evidence.back().sensitivity = kMadeSensitivity_V_Pa;
    }
    const double first_Pa = madeEvidence({.velocity_m_s = 480.0}).step_Pa.value();
    for (ShotEvidence &shot : evidence)
        shot.typedStep_Pa = shot.measurement->typedStep_Pa = shot.step_Pa = first_Pa;
    const MadeComparison made(std::move(evidence));
    ShockSettings settings;
    settings.step_Pa = first_Pa;
    const Findings once = judged(made, settings);
    const Finding *told = findingOf(once, "CHK-002");
    QVERIFY(told != nullptr);
    QCOMPARE(told->severity, Severity::Block);
    compareWithItsNumbers(*told, worstOf(made, 2, {Compared::Step})); // the first one is right
    QVERIFY(names(*told, C::Typed));
    settings.step_Pa = PerShot({first_Pa, first_Pa});
    QCOMPARE(findingOf(judged(made, settings), "CHK-002")->severity, Severity::Caution);
}

void TestConsistencyFindings::oneShotAlone_doesNotBlock()
{
    const MadeComparison made(std::vector<MadeShot>{{.typedVelocity_m_s = 600.0}});
    ShockSettings settings;
    settings.velocity_m_s = 600.0;
    QCOMPARE(findingOf(judged(made, settings), "CHK-002")->severity, Severity::Caution);
}

void TestConsistencyFindings::counters_neverBlock()
{
    const WayComparison check{.of = Compared::Velocity,
        .a = Way::Counters,
        .b = Way::Arrivals,
        .shot = 1,
        .value_a = 500.0,
        .value_b = 520.0,
        .u = 1.0,
        .unit = "m/s"};
    const MadeComparison made(std::vector<MadeShot>(2));
    ShockSettings settings;
    settings.velocity_m_s = 500.0;
    const Findings told = judgeConsistency(*made.compared, {check}, settings);
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].id, std::string("CHK-002"));
    QCOMPARE(told[0].severity, Severity::Caution);
    compareWithItsNumbers(told[0], check);
}

void TestConsistencyFindings::whatOthersSay_isNotSaidAgain_data()
{
    QTest::addColumn<Compared>("of");
    QTest::newRow("arrival: SHK-010") << Compared::Arrival;
    QTest::newRow("shots: RSP-002") << Compared::Shots;
    QTest::newRow("driver: SHK-006") << Compared::P4;
}

void TestConsistencyFindings::whatOthersSay_isNotSaidAgain()
{
    QFETCH(Compared, of);
    const WayComparison check{.of = of, .shot = 1, .value_a = 2.0, .value_b = 1.0, .u = 0.1};
    QVERIFY(!check.agrees());
    const MadeComparison made(std::vector<MadeShot>(1));
    QVERIFY(judgeConsistency(*made.compared, {check}, {}).empty());
}

void TestConsistencyFindings::unexplained_namesAllThatActs_data()
{
    QTest::addColumn<Compared>("of");
    QTest::addColumn<QString>("id");
    QTest::addColumn<std::vector<C>>("causes");
    QTest::newRow("mach") << Compared::Mach << "CHK-001"
                          << std::vector<C>{C::Rate, C::Distance, C::Gas, C::Temperature};
    QTest::newRow("p2") << Compared::P2Rise << "SHK-002"
                        << std::vector<C>{C::Pressure, C::Scale, C::Distance};
    QTest::newRow("p5") << Compared::P5Rise << "SHK-002"
                        << std::vector<C>{C::Pressure, C::Scale, C::Distance};
    QTest::newRow("card") << Compared::Sensitivity << "CHK-003"
                          << std::vector<C>{C::Scale, C::Pressure};
    QTest::newRow("velocity") << Compared::Velocity << "CHK-002" << std::vector<C>{C::Typed};
    QTest::newRow("step") << Compared::Step << "CHK-002" << std::vector<C>{C::Typed};
}

void TestConsistencyFindings::unexplained_namesAllThatActs()
{
    QFETCH(Compared, of);
    QFETCH(QString, id);
    QFETCH(std::vector<C>, causes);
    // A contradiction that the shots, which are all right, do not hold.
    const WayComparison check{
        .of = of, .shot = 1, .channel = "side 7", .value_a = 2.0, .value_b = 1.0, .u = 0.1};
    const MadeComparison made(std::vector<MadeShot>(1));
    const Findings told = judgeConsistency(*made.compared, {check}, {});
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].id, id.toStdString());
    QCOMPARE(told[0].causes, causes);
}

void TestConsistencyFindings::wrongOrder_concernsNoSingleShot()
{
    const MadeComparison made(std::vector<MadeShot>(1));
    auto checks = made.compared->comparisons();
    checks.push_back({.of = Compared::Levels, .a = Way::Names, .b = Way::Steps});
    QVERIFY(judgeConsistency(*made.compared, checks, {}).empty());
    checks.back().isInOrder = false;
    const Findings told = judgeConsistency(*made.compared, checks, {});
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].id, std::string("CHK-004"));
    QCOMPARE(told[0].severity, Severity::Caution);
    QCOMPARE(told[0].shot, Index(0));
    QVERIFY(!told[0].value && !told[0].limit);
    QCOMPARE(told[0].causes, std::vector<C>{C::Order});
    checks.back().missing = Message{"one level", {}};
    QVERIFY(judgeConsistency(*made.compared, checks, {}).empty());
}

void TestConsistencyFindings::scatterWithoutAnyContradiction_isTold()
{
    // Up in every other shot, down in the rest: no single fault does that.
    const MadeComparison made = scatteredShots();
    QVERIFY(std::ranges::all_of(made.compared->comparisons(), &WayComparison::agrees));
    const Findings told = judged(made);
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].id, std::string("CHK-005"));
    QCOMPARE(told[0].severity, Severity::Caution);
    QCOMPARE(told[0].shot, Index(0));
    QCOMPARE(*told[0].value, made.compared->chance());
    QCOMPARE(*told[0].limit, 1e-4);
    QVERIFY(*told[0].value < *told[0].limit);
    QCOMPARE(told[0].message.arguments.at(0), std::to_string(made.compared->rows().size()));
    QCOMPARE(told[0].message.arguments.at(1), numberText(made.compared->chiSquare(), 3));
    QVERIFY(told[0].causes.empty());
    QVERIFY(english(told[0].message).find("no single fault") != std::string::npos);
}

void TestConsistencyFindings::scatterOfWhatWasTyped_namesIt()
{
    std::vector<ShotEvidence> evidence;
    for (Index shot = 1; shot <= 8; ++shot)
        evidence.push_back(
            madeOfTypedStep(kMadeSensitivity_V_Pa * (shot % 2 == 0 ? 1.01 : 1.0 / 1.01), shot));
    const MadeComparison made(std::move(evidence));
    const Findings told = judged(made);
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].id, std::string("CHK-005"));
    QCOMPARE(told[0].causes, std::vector<C>{C::Typed});
    QVERIFY(english(told[0].message).find("causes named") != std::string::npos);
}

void TestConsistencyFindings::scatterOfTheShots_isTheirs()
{
    const MadeComparison made = scatteredShots();
    const Findings told
        = judgeConsistency(*made.compared, made.compared->comparisons(), {}, true); // RSP-002
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].id, std::string("CHK-005"));
    QCOMPARE(told[0].causes, std::vector<C>{C::Shots});
    QVERIFY(english(told[0].message).find("alone") == std::string::npos);
    // Nor does none contradict alone where another finding tells of one that does.
    auto checks = made.compared->comparisons();
    checks.push_back(
        {.of = Compared::Arrival, .shot = 1, .value_a = 2.0, .value_b = 1.0, .u = 0.1});
    const Findings beside = judgeConsistency(*made.compared, checks, {});
    QCOMPARE(beside.size(), std::size_t(1));
    QVERIFY(english(beside[0].message).find("alone") == std::string::npos);
}

void TestConsistencyFindings::chanceBeyondCounting_hasABound()
{
    std::vector<ShotEvidence> evidence;
    for (Index shot = 1; shot <= 40; ++shot)
        evidence.push_back(
            madeOfTypedStep(kMadeSensitivity_V_Pa * (shot % 2 == 0 ? 1.015 : 1.0 / 1.015), shot));
    const MadeComparison made(std::move(evidence));
    QVERIFY(made.compared->chance() < 1e-30);
    const Findings told = judged(made);
    QCOMPARE(told[0].id, std::string("CHK-005"));
    QCOMPARE(told[0].message.arguments.at(2), std::string("< 1e-06"));
}

void TestConsistencyFindings::contradictionAlone_isNotToldTwice()
{
    const MadeComparison made(secondWith([](MadeShot &shot) { shot.dutGain = 1.5; }));
    QVERIFY(made.compared->chance() < 1e-4);
    const Findings told = judged(made);
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].id, std::string("CHK-003"));
}

void TestConsistencyFindings::nothingWrong_nothingTold()
{
    QVERIFY(judged(MadeComparison(secondWith([](MadeShot &) {}))).empty());
    QVERIFY(judged(MadeComparison(std::vector<ShotEvidence>{})).empty());
}

DYNCAL_TEST(TestConsistencyFindings)
#include "tst_consistency_findings.moc"
