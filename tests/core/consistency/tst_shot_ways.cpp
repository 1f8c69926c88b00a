// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_random.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

const WayComparison *checkOf(
    const MadeComparison &made, Compared of, Way a, const std::string &channel = {})
{
    const auto &list = made.compared->comparisons();
    const auto found = std::ranges::find_if(list, [&](const WayComparison &check) {
        return check.of == of && check.a == a && (channel.empty() || check.channel == channel);
    });
    return found != list.end() ? &*found : nullptr;
}

/// The comparison's reason, or nothing where it was made or is not there.
std::string whyNot(const MadeComparison &made, Compared of, Way a, const std::string &channel = {})
{
    const WayComparison *check = checkOf(made, of, a, channel);
    return check && check->missing ? english(*check->missing) : std::string();
}

MadeComparison comparedAlone(ShotEvidence evidence, std::vector<StatedUncertainty> stated = {})
{
    return MadeComparison(std::vector<ShotEvidence>{std::move(evidence)}, std::move(stated));
}

bool isNear(double value, double expected, double relative)
{
    return std::abs(value / expected - 1.0) < relative;
}

/// A shock whose velocity is W (1 + a x) at the distance x from the wall: to first order in a it is
/// there x/W (1 - a x/2) before.
ShotEvidence changingShock(double attenuation_per_m)
{
    ShotEvidence evidence = madeEvidence({.places_m = {0.8, 0.5, 0.2}});
    VelocityEstimate &arrivals = evidence.measurement->velocity;
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = arrivals.sightings[i].distance_m;
        const double local = 1.0 + attenuation_per_m * x;
        arrivals.sightings[i].time_s
            = 2e-3 - x / kMadeVelocity_m_s * (1.0 - 0.5 * attenuation_per_m * x);
        const auto states
            = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, local * kMadeVelocity_m_s).value();
        evidence.readings[i].found->time_s = arrivals.sightings[i].time_s;
        evidence.readings[i].found->behind = states.shocked.pressure_Pa - kMadeP1_Pa;
    }
    arrivals.fit = fitVelocity(arrivals.sightings, Attenuation::Linear).value();
    arrivals.velocity_m_s = arrivals.fit->velocity_m_s;
    return evidence;
}

/// The velocity from a counter between 0.8 and 0.5 m, with the arrivals beside it.
ShotEvidence countedShot(double velocity_m_s)
{
    ShotEvidence evidence = madeEvidence({});
    StepMeasurement &m = *evidence.measurement;
    m.recorded = m.velocity;
    m.counters = {{0.8, 0.5, 0.3 / velocity_m_s, 3e-4, 1e-7}};
    m.velocity = {};
    m.velocity.fit = fitCounters(m.counters, Attenuation::None).value();
    m.velocity.velocity_m_s = m.velocity.fit->velocity_m_s;
    return evidence;
}

} // namespace

class TestShotWays : public QObject
{
    Q_OBJECT

private slots:
    void idealTube_allWaysAgreeExactly();
    void everyComparison_isThere();
    void missingReadings_sayWhy();
    void differences_scatterAsTheirU();
    void errorsThatBothWaysShare_cancel();
    void counters_againstArrivals();
    void typedVelocity_withoutArrivals_saysWhy();
    void typedStep_againstTheComputed();
    void stepAtTheSideWall_isThatOfTheIncidentShock();
    void typedStepAlone_isComparedWithTheCard_closedForm();
    void stepOfNoKnownUncertainty_isNotComparedWithTheCard();
    void withoutASensorInTheWall_noRatioOfVelocities();
    void shortPlateau_leavesTheRatioOfVelocities();
    void changingVelocity_isTakenOff_data();
    void changingVelocity_isTakenOff();
    void driverPressure_againstEquation310();
    void cardThatIsExact_addsNothing();
    void arrivals_needThreePlaces();
    void leftOutArrival_isPredictedByTheOthers();
};

void TestShotWays::idealTube_allWaysAgreeExactly()
{
    const MadeComparison made(std::vector<MadeShot>{{}, {.velocity_m_s = 430.0}});
    int count = 0;
    for (const WayComparison &check : made.compared->comparisons()) {
        if (!check.isMade()) { // no driver pressure is recorded
            QCOMPARE(check.of, Compared::P4);
            continue;
        }
        QVERIFY(std::abs(check.value_a / check.value_b - 1.0) < 1e-8);
        QVERIFY(check.u > 0.0 && check.agrees());
        ++count;
    }
    // Per shot: two arrivals, four Mach numbers, two p2, two p5, the card.
    QCOMPARE(count, 2 * 11);
}

void TestShotWays::everyComparison_isThere()
{
    const MadeComparison made(std::vector<MadeShot>{{.typedVelocity_m_s = 512.0}});
    const WayComparison *typed = checkOf(made, Compared::Velocity, Way::Typed);
    QVERIFY(typed && typed->isMade());
    QCOMPARE(typed->value_a, 512.0);
    QVERIFY(std::abs(typed->value_b - kMadeVelocity_m_s) < 1e-6);
    // u of a typed velocity is assumed: 0.2 %, beside that of the arrivals.
    QVERIFY(typed->u > 0.002 * 512.0 && typed->u < 0.003 * 512.0);
    const WayComparison *mach = checkOf(made, Compared::Mach, Way::VelocityRatio, "side 1");
    QVERIFY(mach && std::abs(mach->value_a / mach->value_b - kMadeVelocity_m_s / 512.0) < 1e-4);
}

void TestShotWays::missingReadings_sayWhy()
{
    ShotEvidence evidence = madeEvidence({.places_m = {0.8}, .card = {}});
    evidence.readings[0].found->back.reset();
    evidence.readings[0].pascals.reset();
    const std::vector<StatedUncertainty> stated;
    const ShotWays ways(evidence, stated);
    QVERIFY(ways.made().empty());
    // Arrival, two Mach numbers, the pressure, driver and card.
    QCOMPARE(ways.missing().size(), std::size_t(6));
    for (const WayComparison &check : ways.missing())
        QVERIFY(check.missing && !english(*check.missing).empty());
}

void TestShotWays::differences_scatterAsTheirU()
{
    // All inputs drawn from their own u: the differences have a standard deviation of u.
    const MadeComparison made(std::vector<MadeShot>(1));
    const ShotWays &ways = *made.ways[0];
    const auto &comparisons = made.compared->comparisons();
    constexpr int kDraws = 400;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(std::ssize(ways.made()));
    for (int draw = 0; draw < kDraws; ++draw) {
        RandomStream random(20261125, draw, 3);
        Eigen::VectorXd x(std::ssize(ways.inputs()));
        for (Index i = 0; i < x.size(); ++i) {
            const UncertainInput &input = ways.inputs()[static_cast<std::size_t>(i)];
            x[i] = input.value + input.u * random.nextNormal();
        }
        const auto values = ways.values(ways.at(x)).value();
        for (Index i = 0; i < squares.size(); ++i) {
            const double z
                = (values[2 * i] - values[2 * i + 1]) / comparisons[static_cast<std::size_t>(i)].u;
            squares[i] += z * z / kDraws;
        }
    }
    // Chi square of 400 over 400: standard deviation 0.071.
    for (const double square : squares)
        QVERIFY(std::abs(square - 1.0) < 0.3);
}

void TestShotWays::errorsThatBothWaysShare_cancel()
{
    // T1 moves both ways to M hardly: the ratio does not depend on it, a1 does. But p1 moves
    // neither, and both pressure rises by the same share.
    ShotEvidence evidence = madeEvidence({});
    evidence.measurement->u_p1_Pa = 5000.0;
    const std::vector<StatedUncertainty> stated;
    std::vector<std::unique_ptr<ShotWays>> ways;
    ways.push_back(std::make_unique<ShotWays>(evidence, stated));
    const ComparedShots uncertain(ways);
    const MadeComparison certain(std::vector<MadeShot>(1));
    for (std::size_t i = 0; i < uncertain.comparisons().size(); ++i) {
        const WayComparison &check = uncertain.comparisons()[i];
        if (!check.isMade())
            continue;
        const double ratio = check.u / certain.compared->comparisons()[i].u;
        if (check.of == Compared::Mach || check.of == Compared::Arrival)
            QVERIFY(std::abs(ratio - 1.0) < 1e-6);
        else
            QVERIFY(ratio > 3.0);
    }
}

void TestShotWays::counters_againstArrivals()
{
    const MadeComparison made = comparedAlone(countedShot(1.02 * kMadeVelocity_m_s));
    const WayComparison *check = checkOf(made, Compared::Velocity, Way::Counters);
    QVERIFY(check && check->isMade());
    QVERIFY(isNear(check->value_a, 1.02 * kMadeVelocity_m_s, 1e-9));
    QVERIFY(isNear(check->value_b, kMadeVelocity_m_s, 1e-9));
    QVERIFY(!checkOf(made, Compared::Velocity, Way::Typed));
    // 0.3 mm of 300 mm and 0.1 us of 574 us by the counter; the arrivals add theirs.
    const double uCounter = check->value_a * std::hypot(1e-3, 1e-7 / (0.3 / check->value_a));
    QVERIFY(check->u > uCounter && check->u < 1.2 * uCounter);
}

void TestShotWays::typedVelocity_withoutArrivals_saysWhy()
{
    ShotEvidence evidence = madeEvidence({.typedVelocity_m_s = kMadeVelocity_m_s});
    evidence.measurement->recorded.reset();
    evidence.readings.clear();
    const MadeComparison made = comparedAlone(std::move(evidence));
    QVERIFY(!whyNot(made, Compared::Velocity, Way::Typed).empty());
    QVERIFY(!checkOf(made, Compared::Arrival, Way::ThisArrival));
    const WayComparison *card = checkOf(made, Compared::Sensitivity, Way::Calibration);
    QVERIFY(card && card->isMade() && isNear(card->value_a, kMadeSensitivity_V_Pa, 1e-9));
}

void TestShotWays::typedStep_againstTheComputed()
{
    ShotEvidence evidence = madeEvidence({});
    const double computed_Pa = *evidence.step_Pa;
    const double typed_Pa = 1.1 * computed_Pa;
    evidence.typedStep_Pa = evidence.measurement->typedStep_Pa = evidence.step_Pa = typed_Pa;
    *evidence.sensitivity /= 1.1;
    const MadeComparison made
        = comparedAlone(evidence, {{"step_relative", 0.02, Distribution::Normal, {}}});
    const WayComparison *step = checkOf(made, Compared::Step, Way::Typed);
    QVERIFY(step && step->isMade() && !step->agrees());
    QVERIFY(isNear(step->value_a, typed_Pa, 1e-12));
    QVERIFY(isNear(step->value_b, computed_Pa, 1e-9));
    QVERIFY(step->u > 0.02 * typed_Pa && step->u < 0.022 * typed_Pa);
    // Nothing stated: 0.5 % is assumed.
    const WayComparison assumed
        = *checkOf(comparedAlone(std::move(evidence)), Compared::Step, Way::Typed);
    const double ofVelocity = step->u * step->u - std::pow(0.02 * typed_Pa, 2);
    QVERIFY(isNear(assumed.u * assumed.u, std::pow(0.005 * typed_Pa, 2) + ofVelocity, 1e-6));
    // The sensitivity is that of the step used: the typed one.
    const WayComparison *card = checkOf(made, Compared::Sensitivity, Way::Calibration);
    QVERIFY(isNear(card->value_a, kMadeSensitivity_V_Pa / 1.1, 1e-9));
}

void TestShotWays::stepAtTheSideWall_isThatOfTheIncidentShock()
{
    ShotEvidence evidence = madeEvidence({});
    const auto states = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, kMadeVelocity_m_s).value();
    evidence.measurement->atEndWall = false;
    evidence.typedStep_Pa = evidence.measurement->typedStep_Pa = 1e5;
    const MadeComparison made = comparedAlone(std::move(evidence));
    QVERIFY(isNear(checkOf(made, Compared::Step, Way::Typed)->value_b,
        states.shocked.pressure_Pa - kMadeP1_Pa, 1e-9));
}

void TestShotWays::typedStepAlone_isComparedWithTheCard_closedForm()
{
    const MadeComparison made = comparedAlone(madeOfTypedStep(12.8e-9));
    const WayComparison *card = checkOf(made, Compared::Sensitivity, Way::Calibration);
    QVERIFY(card && card->isMade());
    QVERIFY(isNear(card->value_a, 12.8e-9, 1e-12));
    QVERIFY(isNear(card->value_b, kMadeSensitivity_V_Pa, 1e-12));
    // Level 0.05 % and typed step 0.5 % of the one, 0.5 % of the card.
    const double u = std::hypot(12.8e-9 * 5e-4, 12.8e-9 * 0.005, kMadeSensitivity_V_Pa * 0.005);
    QVERIFY(isNear(card->u, u, 1e-4)); // the quotient by the step is not quite linear
    QVERIFY(!whyNot(made, Compared::Step, Way::Typed).empty());
}

void TestShotWays::stepOfNoKnownUncertainty_isNotComparedWithTheCard()
{
    // As where the state follows from p2 or p4: a step, but neither typed nor with a budget.
    ShotEvidence evidence = madeOfTypedStep(kMadeSensitivity_V_Pa);
    evidence.typedStep_Pa.reset();
    const MadeComparison made = comparedAlone(std::move(evidence));
    QVERIFY(!whyNot(made, Compared::Sensitivity, Way::Calibration).empty());
    QCOMPARE(made.compared->rows().size(), std::size_t(0));
}

void TestShotWays::withoutASensorInTheWall_noRatioOfVelocities()
{
    ShotEvidence evidence = madeEvidence({.places_m = {0.8, 0.5, 0.2}});
    evidence.readings.pop_back();
    VelocityEstimate &arrivals = evidence.measurement->velocity;
    arrivals.sightings.pop_back();
    arrivals.fit = fitVelocity(arrivals.sightings, Attenuation::None).value();
    const MadeComparison made = comparedAlone(std::move(evidence));
    QVERIFY(!whyNot(made, Compared::Mach, Way::VelocityRatio, "side 1").empty());
    const WayComparison *steps = checkOf(made, Compared::Mach, Way::StepRatio, "side 3");
    QVERIFY(steps && steps->isMade() && isNear(steps->value_a, steps->value_b, 1e-8));
    // Also the sensor nearest the wall is placed by the other two.
    const WayComparison *last = checkOf(made, Compared::Arrival, Way::ThisArrival, "side 3");
    QVERIFY(last && last->isMade() && isNear(last->value_a, last->value_b, 1e-8));
}

void TestShotWays::shortPlateau_leavesTheRatioOfVelocities()
{
    ShotEvidence evidence = madeEvidence({.places_m = {0.8}});
    evidence.readings[0].found->back->level = kUnknown;
    const MadeComparison made = comparedAlone(std::move(evidence));
    QVERIFY(!whyNot(made, Compared::Mach, Way::StepRatio).empty());
    QVERIFY(checkOf(made, Compared::Mach, Way::VelocityRatio)->isMade());
    QVERIFY(checkOf(made, Compared::P2Rise, Way::SideSensor)->isMade());
    QVERIFY(!checkOf(made, Compared::P5Rise, Way::SideSensor));
}

void TestShotWays::changingVelocity_isTakenOff_data()
{
    QTest::addColumn<double>("attenuation_per_m");
    QTest::newRow("slows down") << 0.01;
    QTest::newRow("still forms") << -0.005;
}

void TestShotWays::changingVelocity_isTakenOff()
{
    QFETCH(double, attenuation_per_m);
    const MadeComparison made = comparedAlone(changingShock(attenuation_per_m));
    for (const char *side : {"side 1", "side 2", "side 3"}) {
        for (const Way way : {Way::StepRatio, Way::VelocityRatio}) {
            const WayComparison *mach = checkOf(made, Compared::Mach, way, side);
            QVERIFY(mach && mach->isMade());
            QVERIFY(isNear(mach->value_a, mach->value_b, 1e-7));
        }
        const WayComparison *p2 = checkOf(made, Compared::P2Rise, Way::SideSensor, side);
        QVERIFY(isNear(p2->value_a, p2->value_b, 1e-7));
    }
}

void TestShotWays::driverPressure_againstEquation310()
{
    ShotEvidence evidence = madeEvidence({});
    const auto states = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, kMadeVelocity_m_s).value();
    GasModel helium;
    helium.constants = {5.0 / 3.0, 0.0040026};
    const double p4_Pa = driverPressure_Pa(states, Gas{}, helium.constants, 300.0).value();
    evidence.driver = DriverEvidence{1.3 * p4_Pa, helium, 300.0};
    const MadeComparison made = comparedAlone(std::move(evidence));
    const WayComparison *check = checkOf(made, Compared::P4, Way::Recorded);
    QVERIFY(check && check->isMade() && check->agrees());
    QVERIFY(isNear(check->value_a, 1.3 * p4_Pa, 1e-12));
    QVERIFY(isNear(check->value_b, p4_Pa, 1e-8));
    const double uModel = 1.3 * p4_Pa * std::hypot(kDriverModel, kDriverOfShot);
    QVERIFY(check->u > uModel && check->u < 1.05 * uModel);
}

void TestShotWays::cardThatIsExact_addsNothing()
{
    ShotEvidence evidence = madeOfTypedStep(kMadeSensitivity_V_Pa);
    evidence.card->u_relative = 0.0;
    evidence.uLevel_relative = kUnknown; // nor does a level that nobody knows
    const MadeComparison made = comparedAlone(std::move(evidence));
    const WayComparison *card = checkOf(made, Compared::Sensitivity, Way::Calibration);
    QVERIFY(card && card->isMade() && isNear(card->u, 0.005 * kMadeSensitivity_V_Pa, 1e-4));
}

void TestShotWays::arrivals_needThreePlaces()
{
    const MadeComparison made(std::vector<MadeShot>{{.places_m = {0.8}}});
    QVERIFY(!whyNot(made, Compared::Arrival, Way::ThisArrival, "side 1").empty());
    QVERIFY(!checkOf(made, Compared::Arrival, Way::ThisArrival, "DUT"));
}

void TestShotWays::leftOutArrival_isPredictedByTheOthers()
{
    // The middle sensor's distance is 5 mm too large on paper: the other two do not know.
    ShotEvidence evidence = madeEvidence({});
    VelocityEstimate &arrivals = evidence.measurement->velocity;
    arrivals.sightings[1].distance_m += 0.005;
    arrivals.fit = fitVelocity(arrivals.sightings, Attenuation::None).value();
    arrivals.velocity_m_s = arrivals.fit->velocity_m_s;
    const MadeComparison made = comparedAlone(std::move(evidence));
    const WayComparison *check = checkOf(made, Compared::Arrival, Way::ThisArrival, "side 2");
    QVERIFY(check && !check->agrees());
    QVERIFY(isNear(check->value_a, 0.5 / kMadeVelocity_m_s, 1e-8));
    QVERIFY(isNear(check->value_b, 0.505 / kMadeVelocity_m_s, 1e-8));
}

DYNCAL_TEST(TestShotWays)
#include "tst_shot_ways.moc"
