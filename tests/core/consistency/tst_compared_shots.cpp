// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/compared_shots.h"

#include "core/base/distributions.h"
#include "core/base/portable_random.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kLeftOut = 5e-4; ///< relative, of every difference (docs/method/checks.md)

/// Shots of one side sensor and the DUT, changed by somebody.
std::vector<ShotEvidence> twoShots(const std::function<void(ShotEvidence &)> &change)
{
    std::vector<ShotEvidence> shots{madeEvidence({.velocity_m_s = 470.0, .places_m = {0.8}}, 1),
        madeEvidence({.places_m = {0.8}}, 2)};
    for (ShotEvidence &shot : shots)
        change(shot);
    return shots;
}

const WayComparison &headOf(const ComparedShots &shots, Index row)
{
    const auto [shot, way] = shots.rows()[static_cast<std::size_t>(row)];
    return shots.ways()[shot]->made()[way];
}

Index rowOf(const ComparedShots &shots, Index shot, Compared of, Way a)
{
    for (Index row = 0; row < std::ssize(shots.rows()); ++row) {
        const WayComparison &head = headOf(shots, row);
        if (head.shot == shot && head.of == of && head.a == a)
            return row;
    }
    throw std::runtime_error("no such row");
}

/// Between the same comparison of the two shots.
double correlation(const MadeComparison &made, Compared of, Way a)
{
    const Eigen::MatrixXd &V = made.compared->covariance();
    const Index first = rowOf(*made.compared, 1, of, a);
    const Index second = rowOf(*made.compared, 2, of, a);
    return V(first, second) / std::sqrt(V(first, first) * V(second, second));
}

std::vector<CheckPoint> nominalOf(const ComparedShots &shots)
{
    std::vector<CheckPoint> points;
    for (const ShotWays *ways : shots.ways())
        points.push_back(ways->nominal());
    return points;
}

/// Name of an input among all shots: one error where it is common.
std::string errorName(const UncertainInput &input, Index shot)
{
    return input.common ? input.quantity : input.quantity + " in shot " + std::to_string(shot);
}

/// Points of all shots where every error is so many u off.
std::vector<CheckPoint> pointsAt(
    const ComparedShots &shots, const std::map<std::string, double> &errors)
{
    std::vector<CheckPoint> points;
    for (const ShotWays *ways : shots.ways()) {
        Eigen::VectorXd x(std::ssize(ways->inputs()));
        for (Index i = 0; i < x.size(); ++i) {
            const UncertainInput &input = ways->inputs()[static_cast<std::size_t>(i)];
            const auto error = errors.find(errorName(input, ways->evidence().shot));
            x[i] = input.value + (error != errors.end() ? error->second * input.u : 0.0);
        }
        points.push_back(ways->at(x));
    }
    return points;
}

std::map<std::string, double> allErrors(const ComparedShots &shots)
{
    std::map<std::string, double> errors;
    for (const ShotWays *ways : shots.ways())
        for (const UncertainInput &input : ways->inputs())
            errors[errorName(input, ways->evidence().shot)] = 0.0;
    return errors;
}

Eigen::MatrixXd leftOut(Index count)
{
    return Eigen::MatrixXd::Identity(count, count) * (kLeftOut * kLeftOut);
}

/// By the widths of the differences.
Eigen::MatrixXd normalised(const Eigen::MatrixXd &V, const Eigen::MatrixXd &by)
{
    const Eigen::VectorXd u = by.diagonal().cwiseSqrt();
    return V.cwiseQuotient(u * u.transpose());
}

} // namespace

class TestComparedShots : public QObject
{
    Q_OBJECT

private slots:
    void differences_areLogarithmsOfWhatIsCompared();
    void covariance_isThatOfEveryErrorAlone();
    void covariance_isThatOfDraws();
    void errorOfASharedDistance_isOneErrorInAllShots();
    void errorOfAnArrival_isAnotherOneInEveryShot();
    void chiSquare_ofTwoShots_closedForm();
    void chiSquare_ofShotsThatShareErrors_doesNotCountThemTwice();
    void sameShotTwice_isStillJudged();
    void shotThatCannotBeComputed_takesNoOtherWithIt();
    void wayThatEndsWithinItsUncertainty_takesNoOtherWithIt();
    void signsThatDiffer_areAContradictionWithoutARow();
    void pointsThatCannotBeComputed_giveNothing();
    void noShots_nothingIsUnlikely();
};

void TestComparedShots::differences_areLogarithmsOfWhatIsCompared()
{
    const MadeComparison made(
        std::vector<MadeShot>{{.trueT1_K = 300.0}, {.velocity_m_s = 430.0, .sideGain = 1.1}});
    const ComparedShots &shots = *made.compared;
    QVERIFY(shots.differences().size() > 20);
    QCOMPARE(shots.differencesAt(nominalOf(shots)), shots.differences());
    Index row = 0;
    for (const WayComparison &check : shots.comparisons()) {
        if (!check.isMade())
            continue;
        QCOMPARE(headOf(shots, row).shot, check.shot);
        QCOMPARE(headOf(shots, row).channel, check.channel);
        QCOMPARE(shots.differences()[row], std::log(check.value_a / check.value_b));
        // Of small differences, u of the logarithm is u over the value, and what is left out.
        if (std::abs(shots.differences()[row]) < 1e-6) {
            const double variance = shots.covariance()(row, row) - kLeftOut * kLeftOut;
            QVERIFY(std::abs(std::sqrt(variance) * check.value_b / check.u - 1.0) < 1e-5);
        }
        ++row;
    }
    QCOMPARE(row, shots.differences().size());
}

void TestComparedShots::covariance_isThatOfEveryErrorAlone()
{
    // Each error for itself in all shots, by differences of a hundredth of its u.
    const MadeComparison made(twoShots([](ShotEvidence &) {}));
    const ComparedShots &shots = *made.compared;
    const Index count = shots.differences().size();
    Eigen::MatrixXd V = leftOut(count);
    for (const auto &[name, zero] : allErrors(shots)) {
        const Eigen::VectorXd up = shots.differencesAt(pointsAt(shots, {{name, 0.01}}));
        const Eigen::VectorXd down = shots.differencesAt(pointsAt(shots, {{name, -0.01}}));
        const Eigen::VectorXd moved = (up - down) / 0.02;
        V += moved * moved.transpose();
    }
    const Eigen::MatrixXd off = normalised(V - shots.covariance(), V);
    QVERIFY(off.cwiseAbs().maxCoeff() < 1e-3);
}

void TestComparedShots::covariance_isThatOfDraws()
{
    // 4000 draws, seed 20261125: the correlation of two differences has a standard deviation of
    // at most 0.016, their variances one of 0.022; five of these.
    const MadeComparison made(twoShots([](ShotEvidence &) {}));
    const ComparedShots &shots = *made.compared;
    constexpr int kDraws = 4000;
    std::map<std::string, double> errors = allErrors(shots);
    const Index count = shots.differences().size();
    Eigen::MatrixXd V = leftOut(count);
    for (int draw = 0; draw < kDraws; ++draw) {
        RandomStream random(20261125, draw, 7);
        for (auto &[name, error] : errors)
            error = random.nextNormal();
        const Eigen::VectorXd d
            = shots.differencesAt(pointsAt(shots, errors)) - shots.differences();
        V += d * d.transpose() / kDraws;
    }
    const Eigen::MatrixXd off = normalised(V - shots.covariance(), shots.covariance());
    QVERIFY(off.cwiseAbs().maxCoeff() < 0.11);
}

void TestComparedShots::errorOfASharedDistance_isOneErrorInAllShots()
{
    // 3 cm of 80 cm: 4 % of both velocities.
    const MadeComparison made(twoShots(
        [](ShotEvidence &shot) { shot.measurement->velocity.sightings[0].u_distance_m = 0.03; }));
    QVERIFY(correlation(made, Compared::Mach, Way::StepRatio) > 0.98);
    QVERIFY(correlation(made, Compared::Mach, Way::VelocityRatio) > 0.98);
    QVERIFY(correlation(made, Compared::Sensitivity, Way::Calibration) > 0.98);
}

void TestComparedShots::errorOfAnArrival_isAnotherOneInEveryShot()
{
    // 60 us of 1.6 ms: about as much.
    const MadeComparison made(twoShots(
        [](ShotEvidence &shot) { shot.measurement->velocity.sightings[0].u_time_s = 6e-5; }));
    QVERIFY(correlation(made, Compared::Mach, Way::StepRatio) < 0.1);
    QVERIFY(correlation(made, Compared::P5Rise, Way::SideSensor) < 0.1);
    QVERIFY(correlation(made, Compared::Sensitivity, Way::Calibration) < 0.1);
}

void TestComparedShots::chiSquare_ofTwoShots_closedForm()
{
    // Each has its level (0.05 %) and what is left out; typed step and card (0.5 % each) are one
    // error of both.
    const MadeComparison made(
        std::vector<ShotEvidence>{madeOfTypedStep(kMadeSensitivity_V_Pa * std::exp(0.004), 1),
            madeOfTypedStep(kMadeSensitivity_V_Pa * std::exp(0.001), 2)});
    const double own = 5e-4 * 5e-4 + kLeftOut * kLeftOut;
    const double common = 2.0 * 0.005 * 0.005;
    const Eigen::MatrixXd &V = made.compared->covariance();
    QVERIFY(std::abs(V(0, 0) / (own + common) - 1.0) < 1e-4);
    QVERIFY(std::abs(V(0, 1) / common - 1.0) < 1e-4);
    // Half the square of the difference is own, that of the sum own + 2 common.
    const double chiSquare = 0.003 * 0.003 / 2.0 / own + 0.005 * 0.005 / 2.0 / (own + 2.0 * common);
    QVERIFY(std::abs(made.compared->chiSquare() / chiSquare - 1.0) < 1e-4);
    // Two degrees of freedom: exp(-chi^2/2).
    QVERIFY(std::abs(made.compared->chance() / std::exp(-0.5 * made.compared->chiSquare()) - 1.0)
        < 1e-10);
}

void TestComparedShots::chiSquare_ofShotsThatShareErrors_doesNotCountThemTwice()
{
    // The same 0.7 % in all shots is one error of 1 u, however many shots show it.
    const auto chiSquareOf = [](Index count) {
        std::vector<ShotEvidence> shots;
        for (Index shot = 1; shot <= count; ++shot)
            shots.push_back(madeOfTypedStep(kMadeSensitivity_V_Pa * std::exp(0.00707), shot));
        return MadeComparison(std::move(shots)).compared->chiSquare();
    };
    QVERIFY(std::abs(chiSquareOf(1) - 1.0) < 0.02);
    QVERIFY(std::abs(chiSquareOf(20) - 1.0) < 0.02);
}

void TestComparedShots::sameShotTwice_isStillJudged()
{
    // All errors are the same, those of one shot too; only what is left out is not.
    const ShotEvidence shot = madeEvidence({.sideGain = 1.2});
    const MadeComparison once(std::vector<ShotEvidence>{shot});
    const MadeComparison twice(std::vector<ShotEvidence>{shot, shot});
    const Eigen::VectorXd spread
        = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(twice.compared->covariance())
              .eigenvalues();
    QVERIFY(spread.minCoeff() > 0.999 * kLeftOut * kLeftOut);
    QVERIFY(std::isfinite(twice.compared->chiSquare()));
    QVERIFY(twice.compared->chiSquare() >= once.compared->chiSquare());
    // The second time halves the part that is left out, and no more.
    QVERIFY(twice.compared->chiSquare() < 2.0 * once.compared->chiSquare());
}

void TestComparedShots::shotThatCannotBeComputed_takesNoOtherWithIt()
{
    const auto make = [](Index shot) { return madeEvidence({.sideGain = 1.05}, shot); };
    ShotEvidence hot = make(2);
    hot.measurement->state.temperature_K = 500.0; // SHK-004
    const MadeComparison all(std::vector<ShotEvidence>{make(1), hot, make(3)});
    const MadeComparison others(std::vector<ShotEvidence>{make(1), make(3)});
    QCOMPARE(all.compared->ways().size(), std::size_t(2));
    QCOMPARE(all.compared->differences(), others.compared->differences());
    QCOMPARE(all.compared->covariance(), others.compared->covariance());
    int told = 0;
    for (const WayComparison &check : all.compared->comparisons()) {
        if (check.shot != 2)
            continue;
        QVERIFY(!check.isMade() && !english(*check.missing).empty());
        ++told;
    }
    const auto ofOneShot = all.ways[0]->made().size() + all.ways[0]->missing().size();
    QCOMPARE(std::size_t(told), ofOneShot);
}

void TestComparedShots::wayThatEndsWithinItsUncertainty_takesNoOtherWithIt()
{
    // A ratio of steps that belongs to M 1.0013 ends, with its u of 1 %, where there is no shock.
    const auto weak
        = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, 1.0013 * soundSpeed_m_s(Gas{}, kMadeT1_K))
              .value();
    const double ratio = (weak.reflected.pressure_Pa - weak.shocked.pressure_Pa)
        / (weak.shocked.pressure_Pa - kMadeP1_Pa);
    ShotEvidence evidence = madeEvidence({.places_m = {0.8}});
    SideArrival &found = *evidence.readings[0].found;
    found.back->level = found.behind + ratio * (found.behind - found.before);
    const MadeComparison made(std::vector<ShotEvidence>{evidence});
    const auto &checks = made.compared->comparisons();
    const auto isRatio = [](const WayComparison &c) { return c.a == Way::StepRatio; };
    const auto steps = std::ranges::find_if(checks, isRatio);
    QVERIFY(steps != checks.end() && !steps->isMade() && !english(*steps->missing).empty());
    // Ratio of velocities, p2, p5 and the card are there.
    QCOMPARE(std::ranges::count_if(checks, &WayComparison::isMade), 4);
    QCOMPARE(made.compared->rows().size(), std::size_t(4));
}

void TestComparedShots::signsThatDiffer_areAContradictionWithoutARow()
{
    // A side sensor of the wrong polarity: there is no logarithm, but numbers and a u.
    const MadeComparison made(std::vector<MadeShot>{{.places_m = {0.8}, .sideGain = -1.0}});
    int inverted = 0;
    for (const WayComparison &check : made.compared->comparisons()) {
        if (check.of != Compared::P2Rise && check.of != Compared::P5Rise)
            continue;
        QVERIFY(check.isMade() && check.value_a < 0.0 && check.value_b > 0.0);
        QVERIFY(check.u > 0.0 && !check.agrees());
        ++inverted;
    }
    QCOMPARE(inverted, 2);
    QCOMPARE(made.compared->rows().size(), std::size_t(3)); // two Mach numbers and the card
    QVERIFY(made.compared->differences().allFinite());
    QVERIFY(made.compared->chance() > 0.9);
}

void TestComparedShots::pointsThatCannotBeComputed_giveNothing()
{
    const MadeComparison made(std::vector<MadeShot>(2));
    auto points = nominalOf(*made.compared);
    points[1].step.state.temperature_K = 500.0;
    QCOMPARE(made.compared->differencesAt(points).size(), Index(0));
    points = nominalOf(*made.compared);
    points[0].gain *= -1.0; // has no logarithm
    QCOMPARE(made.compared->differencesAt(points).size(), Index(0));
}

void TestComparedShots::noShots_nothingIsUnlikely()
{
    const MadeComparison made(std::vector<ShotEvidence>{});
    QVERIFY(made.compared->comparisons().empty() && made.compared->rows().empty());
    QCOMPARE(made.compared->chiSquare(), 0.0);
    QCOMPARE(made.compared->chance(), 1.0);
}

DYNCAL_TEST(TestComparedShots)
#include "tst_compared_shots.moc"
