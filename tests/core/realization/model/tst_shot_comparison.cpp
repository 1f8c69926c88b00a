// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The test that decides which uncertainty a certificate prints, against its closed forms. The shots
// are step responses plus white noise, so nothing but the comparison itself is between truth and
// outcome; whole calibrations: tst_homogeneity.cpp.

#include "core/realization/model/homogeneity.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/refinement/refinement.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using testing::Noise;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kF0_Hz = 30e3;
constexpr double kZeta = 0.05;
constexpr Index kSamples = 200;
constexpr Index kQuiet = 600; ///< samples before the start

/// One shot: `step` of a sensor with its noise relative to the step.
struct ShotTruth
{
    double step = 1.0;
    double f0_Hz = kF0_Hz;
    double relativeNoise = 0.01;
    double secondShare = 0.0; ///< of a mode at 4 f0
    double rate_Hz = kRate_Hz;
};

ModelSeries seriesOf(const ShotTruth &truth, Index shot, Noise &noise)
{
    const double sd = truth.step * truth.relativeNoise;
    Eigen::VectorXd y = truth.step * (1.0 - truth.secondShare)
        * testing::sampledStep(truth.f0_Hz, kZeta, truth.rate_Hz, kSamples);
    y += truth.step * truth.secondShare
        * testing::sampledStep(4.0 * truth.f0_Hz, kZeta, truth.rate_Hz, kSamples);
    y += noise.series(kSamples, sd);
    return testing::makeSeries(shot, y, truth.rate_Hz, noise.series(kQuiet, sd));
}

ModelInput inputOf(const std::vector<ShotTruth> &shots, std::uint64_t seed)
{
    Noise noise(seed);
    std::vector<ModelSeries> series;
    for (const ShotTruth &shot : shots)
        series.push_back(seriesOf(shot, std::ssize(series) + 1, noise));
    return testing::makeInput(ResponseTreatment::StepDeflated, shots.front().rate_Hz, series);
}

struct Compared
{
    SensorModel model;
    ModelAssessment found;
};

/// Draft and poles as the realisation hands them over, `modes` of them at f0 and 4 f0.
Compared compared(const ModelInput &input, Index modes = 1)
{
    Compared result;
    std::vector<std::complex<double>> z;
    for (Index m = 0; m < modes; ++m) {
        const double scale = input.sampleRate_Hz / kRate_Hz * (m == 0 ? 1.0 : 4.0);
        z.push_back(testing::secondOrderPole(kF0_Hz * scale, kZeta, input.sampleRate_Hz));
        z.push_back(std::conj(z.back()));
    }
    ModelDraft &draft = result.model.draft;
    draft = linearDraft(input, z);
    refineDraft(input, draft, {});
    for (std::size_t i = 0; i < draft.poles_rad_s.size(); ++i) {
        Pole pole;
        pole.s_rad_s = draft.poles_rad_s[i];
        pole.poleClass = PoleClass::Sensor;
        pole.amplitude = std::abs(draft.series.front().amplitudes[static_cast<Index>(i)]);
        pole.frequency_Hz = std::abs(pole.s_rad_s) / (2.0 * M_PI);
        result.model.poles.push_back(pole);
        if (draft.refinement) {
            const PoleFigures figures = poleFigures(*draft.refinement, static_cast<Index>(i));
            pole.u_frequency_Hz = figures.u_frequency_Hz;
            pole.u_dampingRatio = figures.u_dampingRatio;
            pole.coverageFactor = coverageFactor95(draft.noise.dof);
        }
        result.found.poles.push_back(pole);
    }
    compareShots(input, result.model, result.found, {});
    return result;
}

/// The fit of one pair to one shot alone, from the joint result: Re s, Im s and their covariance.
struct Alone
{
    Eigen::Vector2d theta;
    Eigen::Matrix2d covariance;
};

std::vector<Alone> fittedAlone(const ModelInput &input, const ModelDraft &draft)
{
    std::vector<Alone> list;
    for (const RefinementRecord &record : refinementRecords(input)) {
        const auto fit = refinePoles({record}, draft.poles_rad_s, true).value();
        const std::complex<double> s = fit.poles_rad_s[0];
        list.push_back({{s.real(), s.imag()}, fit.covariance.topLeftCorner<2, 2>()});
    }
    return list;
}

/// Q as a sum over all pairs of shots would not be; here from the weighted mean itself.
double statisticOf(const std::vector<Alone> &shots)
{
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
    for (const Alone &shot : shots) {
        information += shot.covariance.inverse();
        weighted += shot.covariance.inverse() * shot.theta;
    }
    const Eigen::Vector2d mean = information.inverse() * weighted;
    double sum = 0.0;
    for (const Alone &shot : shots)
        sum += (shot.theta - mean).dot(shot.covariance.inverse() * (shot.theta - mean));
    return sum;
}

double exceeds2(double x) ///< chi square, 2 degrees of freedom
{
    return std::exp(-x / 2.0);
}

double exceeds4(double x) ///< 4 degrees of freedom
{
    return std::exp(-x / 2.0) * (1.0 + x / 2.0);
}

bool isFlagged(const Pole &pole)
{
    return std::find(pole.flags.begin(), pole.flags.end(), "shots-disagree") != pole.flags.end();
}

} // namespace

class TestShotComparison : public QObject
{
    Q_OBJECT

private slots:
    void threeShots_statisticIsTheWeightedSumOfSquares();
    void consistentShots_probabilityIsUniform_data();
    void consistentShots_probabilityIsUniform();
    void oneShotApart_statisticGrowsByTheNoncentrality();
    void smallDifference_isFoundAsOftenAsTheoryDemands();
    void unitsTimesAndOrder_changeNothing();
    void sameShotTwice_agreesExactly();
    void noiseFreeShots_sameSensor_pass();
    void twoShotsApart_weightedScatterAndStudent();
    void scatterBelowNoise_intervalIsNotNarrower();
    void twoPoles_eachAtHalfTheLevel();
    void modeMissingInOneShot_isWhatTheEnergySays();
    void modeInOneOfTwoShots_uncertaintyUnknown();
    void levels_fittedTogetherFromLowToHigh();
    void oneShot_isDescribedNotTested();
    void brokenShot_isUnknownAndLeftOut();
    void withoutRefinementOrShotNumbers_nothing();
    void stopped_nothingIsJudged();
    void judgement_saysPoleProbabilityAndRange();
};

void TestShotComparison::threeShots_statisticIsTheWeightedSumOfSquares()
{
    constexpr double kRounding = 1e-6; // the fits stop at 1e-12 of the cost
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const ModelInput input
            = inputOf({{0.3, kF0_Hz, 0.02}, {0.6, 1.001 * kF0_Hz, 0.01}, {0.9}}, seed);
        const Compared result = compared(input);
        const double expected = statisticOf(fittedAlone(input, result.model.draft));
        const Homogeneity &found = result.found.homogeneity.value();
        QVERIFY(std::abs(found.statistic - expected) < kRounding * std::max(1.0, expected));
        QCOMPARE(found.dof, 4.0);
        QVERIFY(std::abs(found.probability - exceeds4(expected)) < kRounding);
        QCOMPARE(found.passed, found.probability >= 0.01);
        QCOMPARE(isFlagged(result.found.poles[0]), !found.passed);
    }
}

void TestShotComparison::consistentShots_probabilityIsUniform_data()
{
    QTest::addColumn<int>("shots");
    QTest::addColumn<bool>("alike");
    QTest::newRow("two shots") << 2 << true;
    QTest::newRow("three unlike steps and noises") << 3 << false;
}

void TestShotComparison::consistentShots_probabilityIsUniform()
{
    QFETCH(int, shots);
    QFETCH(bool, alike);
    constexpr int kRuns = 500;
    std::vector<double> probabilities;
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
        std::vector<ShotTruth> truth;
        for (int i = 0; i < shots; ++i)
            truth.push_back(alike ? ShotTruth{} : ShotTruth{0.3 + 0.3 * i, kF0_Hz, 0.02 / (i + 1)});
        probabilities.push_back(
            compared(inputOf(truth, 100 + seed)).found.homogeneity->probability);
    }
    std::sort(probabilities.begin(), probabilities.end());
    double distance = 0.0; // Kolmogorov and Smirnov
    for (int i = 0; i < kRuns; ++i) {
        const double p = probabilities[static_cast<std::size_t>(i)];
        distance = std::max({distance, (i + 1.0) / kRuns - p, p - static_cast<double>(i) / kRuns});
    }
    const auto alarms = std::lower_bound(probabilities.begin(), probabilities.end(), 0.01)
        - probabilities.begin();
    qInfo("largest distance %.3f, %d of %d false alarms", distance, int(alarms), kRuns);
    QVERIFY(distance < 1.63 / std::sqrt(kRuns)); // its 1 % point
    QVERIFY(alarms >= 1 && alarms <= 13); // binomial of 500 at 1 %: 0.1 % beyond 13, 0.7 % at 0
}

void TestShotComparison::oneShotApart_statisticGrowsByTheNoncentrality()
{
    // E(Q) = degrees + lambda, Var(Q) = 2 (degrees + 2 lambda), lambda = Q of the truths.
    constexpr int kRuns = 150;
    const double shift = 0.0015;
    double difference = 0.0;
    double variance = 0.0;
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
        const ModelInput input = inputOf({{0.3}, {0.6, kF0_Hz * (1.0 + shift)}, {0.9}}, seed);
        const Compared result = compared(input);
        std::vector<Alone> truth = fittedAlone(input, result.model.draft);
        const Eigen::Vector2d s
            = 2.0 * M_PI * kF0_Hz * Eigen::Vector2d(-kZeta, std::sqrt(1.0 - kZeta * kZeta));
        for (std::size_t i = 0; i < truth.size(); ++i)
            truth[i].theta = s * (i == 1 ? 1.0 + shift : 1.0);
        const double lambda = statisticOf(truth);
        QVERIFY(lambda > 3.0);
        difference += result.found.homogeneity->statistic - 4.0 - lambda;
        variance += 2.0 * (4.0 + 2.0 * lambda);
    }
    qInfo("mean excess %.2f +- %.2f", difference / kRuns, std::sqrt(variance) / kRuns);
    QVERIFY(std::abs(difference) < 4.0 * std::sqrt(variance));
}

void TestShotComparison::smallDifference_isFoundAsOftenAsTheoryDemands()
{
    // Two shots, chi square with 2 degrees of freedom, 9.2103 at 1 %. Of a noncentral one with
    // lambda 15 that is exceeded in 83.8 %: /usr/bin/python3 -c "from scipy.stats import chi2,
    // ncx2; print(ncx2.sf(chi2.isf(0.01, 2), 2, 15))" -> 0.8378936
    constexpr double kLambda = 15.0;
    constexpr double kPower = 0.8378936;
    constexpr int kRuns = 200;
    const Compared plain = compared(inputOf({{}, {}}, 7));
    // Both shots alike: lambda = (shift of f0)^2 / (2 u^2), u of one shot.
    const double shift_Hz = std::sqrt(2.0 * kLambda) * plain.found.perShot[0].u_frequency_Hz;
    int found = 0;
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed)
        found += !compared(inputOf({{}, {1.0, kF0_Hz + shift_Hz}}, 900 + seed))
                      .found.homogeneity->passed;
    qInfo("%d of %d found", found, kRuns);
    const double sd = std::sqrt(kPower * (1.0 - kPower) / kRuns);
    QVERIFY(std::abs(static_cast<double>(found) / kRuns - kPower) < 3.3 * sd);
}

void TestShotComparison::unitsTimesAndOrder_changeNothing()
{
    const std::vector<ShotTruth> shots{{0.3, kF0_Hz, 0.02}, {0.6, 1.002 * kF0_Hz}, {0.9}};
    const ModelInput input = inputOf(shots, 3);
    const Homogeneity plain = compared(input).found.homogeneity.value();
    constexpr double kStop = 1e-6; // where the descent may stop

    ModelInput scaled = input; // recorded in another unit
    for (ModelSeries &series : scaled.series)
        series = testing::makeSeries(series.shot, 1e-4 * series.y, kRate_Hz, 1e-4 * series.noise);
    QVERIFY(std::abs(compared(scaled).found.homogeneity->statistic / plain.statistic - 1) < kStop);

    std::vector<ShotTruth> faster = shots; // the same samples of a sensor a hundred times as fast
    for (ShotTruth &shot : faster) {
        shot.rate_Hz *= 100.0;
        shot.f0_Hz *= 100.0;
    }
    const Homogeneity fast = compared(inputOf(faster, 3)).found.homogeneity.value();
    QVERIFY(std::abs(fast.statistic / plain.statistic - 1.0) < kStop);
    QVERIFY(std::abs(fast.frequency_Hz / plain.frequency_Hz - 100.0) < 100.0 * kStop);

    ModelInput turned = input;
    std::rotate(turned.series.begin(), turned.series.begin() + 1, turned.series.end());
    const Compared other = compared(turned);
    QVERIFY(std::abs(other.found.homogeneity->statistic / plain.statistic - 1.0) < kStop);
    QCOMPARE(other.found.perShot[0].shots, std::vector<Index>{2});
    QCOMPARE(other.found.perShot[2].shots, std::vector<Index>{1});
}

void TestShotComparison::sameShotTwice_agreesExactly()
{
    ModelInput input = inputOf({{}, {}}, 5);
    input.series[1] = input.series[0];
    const Homogeneity found = compared(input).found.homogeneity.value();
    QCOMPARE(found.dof, 2.0);
    QVERIFY(found.statistic < 1e-6); // squares of 1e13 cancel but for rounding
    QVERIFY(found.passed && found.probability > 1.0 - 1e-6);
}

void TestShotComparison::noiseFreeShots_sameSensor_pass()
{
    const Compared result
        = compared(inputOf({{0.3, kF0_Hz, 0.0}, {0.6, kF0_Hz, 0.0}, {0.9, kF0_Hz, 0.0}}, 1));
    QVERIFY(result.found.homogeneity->passed);
    for (const LevelPole &shot : result.found.perShot) {
        QVERIFY(std::abs(shot.frequency_Hz / kF0_Hz - 1.0) < 1e-9);
        QVERIFY(std::abs(shot.dampingRatio - kZeta) < 1e-9);
    }
}

void TestShotComparison::twoShotsApart_weightedScatterAndStudent()
{
    const Compared result = compared(inputOf({{1.0, kF0_Hz, 0.01}, {1.0, 1.02 * kF0_Hz, 0.03}}, 2));
    const auto &shots = result.found.perShot;
    QVERIFY(!result.found.homogeneity->passed);
    const auto scatter = [](double a, double u_a, double b, double u_b) {
        const double wa = 1.0 / (u_a * u_a);
        const double wb = 1.0 / (u_b * u_b);
        return std::abs(a - b) / std::sqrt(2.0) * std::hypot(wa, wb) / (wa + wb);
    };
    constexpr double kRounding = 1e-9;
    for (const Pole &pole : result.found.poles) {
        const double u = scatter(shots[0].frequency_Hz, shots[0].u_frequency_Hz,
            shots[1].frequency_Hz, shots[1].u_frequency_Hz);
        QVERIFY(std::abs(pole.u_frequency_Hz / u - 1.0) < kRounding);
        QVERIFY(std::abs(u / (0.02 * kF0_Hz / std::sqrt(2.0)) - 0.9055) < 0.02); // weights 9 : 1
        QVERIFY(std::abs(pole.coverageFactor - 12.706204736) < kRounding); // t of 1 degree
        QVERIFY(isFlagged(pole));
    }
}

void TestShotComparison::scatterBelowNoise_intervalIsNotNarrower()
{
    // The shots differ in f0; zeta they share, so its scatter can fall below the noise by chance.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const ModelInput input = inputOf({{}, {1.0, 1.02 * kF0_Hz}, {1.0, 0.98 * kF0_Hz}}, seed);
        const Compared result = compared(input);
        const PoleFigures noise = poleFigures(*result.model.draft.refinement, 0);
        const double k = coverageFactor95(result.model.draft.noise.dof);
        const Pole &pole = result.found.poles[0];
        QVERIFY(isFlagged(pole));
        QVERIFY(
            pole.coverageFactor * pole.u_dampingRatio >= k * noise.u_dampingRatio * (1.0 - 1e-12));
        QVERIFY(pole.coverageFactor * pole.u_frequency_Hz > k * noise.u_frequency_Hz);
    }
}

void TestShotComparison::twoPoles_eachAtHalfTheLevel()
{
    const ShotTruth shot{1.0, kF0_Hz, 0.01, 0.4};
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Homogeneity found
            = compared(inputOf({shot, shot, shot}, seed), 2).found.homogeneity.value();
        QCOMPARE(found.dof, 4.0);
        const double expected = std::min(1.0, 2.0 * exceeds4(found.statistic));
        QVERIFY(std::abs(found.probability - expected) < 1e-12);
    }
}

void TestShotComparison::modeMissingInOneShot_isWhatTheEnergySays()
{
    // Shot 3 has the first mode only. What the second would hold there, were it as in the others:
    // 2 sum |c p^k|^2 / sd^2 with 2|c| = share/sqrt(1 - zeta^2), p^k from the first sample on.
    constexpr double kShare = 0.4;
    constexpr double kNoise = 0.01;
    const ModelInput input = inputOf(
        {{1.0, kF0_Hz, kNoise, kShare}, {1.0, kF0_Hz, kNoise, kShare}, {1.0, kF0_Hz, kNoise}}, 4);
    const Compared result = compared(input, 2);
    const double decay = std::norm(testing::secondOrderPole(4.0 * kF0_Hz, kZeta, kRate_Hz));
    const double squares = kShare * kShare / 4.0 / (1.0 - kZeta * kZeta);
    const double energy
        = 2.0 * squares * decay / (1.0 - decay) / std::pow(input.series[2].noiseSd, 2);
    const Homogeneity found = result.found.homogeneity.value();
    QVERIFY(!found.passed);
    QVERIFY(std::abs(found.frequency_Hz / (4.0 * kF0_Hz) - 1.0) < 0.01);
    QCOMPARE(found.dof, 2.0);
    // The largest of two shots and what noise leaves in the third: a few units of the root.
    const double excess = std::sqrt(found.statistic) - std::sqrt(energy);
    QVERIFY2(std::abs(excess) < 4.5, qPrintable(QString::number(excess)));
    QVERIFY(isFlagged(result.found.poles[2]) && isFlagged(result.found.poles[3]));
    QVERIFY(!isFlagged(result.found.poles[0]));
    // Of the two shots that have it: Student's factor of one degree of freedom.
    QVERIFY(std::abs(result.found.poles[2].coverageFactor - 12.706204736) < 1e-9);
}

void TestShotComparison::modeInOneOfTwoShots_uncertaintyUnknown()
{
    const Compared result
        = compared(inputOf({{1.0, kF0_Hz, 0.01, 0.4}, {1.0, kF0_Hz, 0.01, 0.0}}, 1), 2);
    for (const std::size_t half : {std::size_t(2), std::size_t(3)}) {
        const Pole &pole = result.found.poles[half];
        QVERIFY(isFlagged(pole));
        QVERIFY(std::isnan(pole.u_frequency_Hz) && std::isnan(pole.u_dampingRatio));
        QVERIFY(std::isnan(pole.coverageFactor));
    }
    QVERIFY(std::isfinite(result.found.poles[0].u_frequency_Hz));
}

void TestShotComparison::levels_fittedTogetherFromLowToHigh()
{
    ModelInput input = inputOf({{0.9}, {0.3, kF0_Hz, 0.03}, {0.8, kF0_Hz, 0.02}, {0.5}}, 8);
    const ShotLevel levels[] = {ShotLevel::High, ShotLevel::Low, ShotLevel::High, ShotLevel::None};
    const double steps[] = {9e5, 3e5, 8e5, 5e5};
    for (std::size_t i = 0; i < 4; ++i) {
        input.series[i].level = levels[i];
        input.series[i].step = steps[i];
    }
    const Compared result = compared(input);
    const auto &perLevel = result.found.perLevel;
    QCOMPARE(perLevel.size(), std::size_t(2));
    QCOMPARE(perLevel[0].shots, std::vector<Index>{2});
    QCOMPARE(perLevel[0].step, 3e5);
    QCOMPARE(perLevel[0].plateauGain, result.found.perShot[1].plateauGain);
    QCOMPARE(perLevel[1].shots, (std::vector<Index>{1, 3}));
    QCOMPARE(perLevel[1].step, 8.5e5);
    // Plateaus: the mean weighted by 1/u^2, from the joint fit of the two.
    const auto records = refinementRecords(input);
    const auto fit
        = refinePoles({records[0], records[2]}, result.model.draft.poles_rad_s, true).value();
    double weights = 0.0;
    double sum = 0.0;
    for (Index i = 0; i < 2; ++i) {
        const Index place = fit.offsets[static_cast<std::size_t>(i)] + 2;
        weights += 1.0 / fit.covariance(place, place);
        sum += fit.records[static_cast<std::size_t>(i)].constant / fit.covariance(place, place);
    }
    QVERIFY(std::abs(perLevel[1].plateauGain / (sum / weights) - 1.0) < 1e-9);
    QVERIFY(std::abs(perLevel[1].u_plateauGain * std::sqrt(weights) - 1.0) < 1e-6);
    QVERIFY(std::abs(perLevel[1].frequency_Hz / poleFigures(fit, 0).frequency_Hz - 1.0) < 1e-9);
    // Relative noise 1 % and 2 %: the weights add up, 1 + 1/4.
    const double ratio = result.found.perShot[0].u_frequency_Hz / perLevel[1].u_frequency_Hz;
    QVERIFY2(std::abs(ratio / std::sqrt(1.25) - 1.0) < 0.1, qPrintable(QString::number(ratio)));
}

void TestShotComparison::oneShot_isDescribedNotTested()
{
    const Compared result = compared(inputOf({{0.7}}, 1));
    QCOMPARE(result.found.perShot.size(), std::size_t(1));
    // Alone it is the joint fit.
    const LevelPole &shot = result.found.perShot[0];
    QVERIFY(std::abs(shot.frequency_Hz / result.found.poles[0].frequency_Hz - 1.0) < 1e-9);
    QVERIFY(std::abs(shot.u_frequency_Hz / result.found.poles[0].u_frequency_Hz - 1.0) < 1e-6);
    QVERIFY(!result.found.homogeneity);
    QVERIFY(!isFlagged(result.found.poles[0]));
    QVERIFY(judgeShots(result.found).empty());
}

void TestShotComparison::brokenShot_isUnknownAndLeftOut()
{
    ModelInput input = inputOf({{}, {}, {}}, 1);
    Compared result = compared(input);
    const double clean = statisticOf([&] {
        auto list = fittedAlone(input, result.model.draft);
        list.pop_back();
        return list;
    }());
    input.series[2].fullRate[17] = std::numeric_limits<double>::quiet_NaN();
    ModelAssessment found;
    found.poles = result.found.poles;
    compareShots(input, result.model, found, {});
    QVERIFY(std::isnan(found.perShot[2].frequency_Hz));
    QVERIFY(std::isnan(found.perShot[2].u_plateauGain));
    QCOMPARE(found.homogeneity->dof, 2.0);
    QVERIFY(std::abs(found.homogeneity->statistic - clean) < 1e-6 * std::max(1.0, clean));
    QVERIFY(std::abs(found.homogeneity->probability - exceeds2(clean)) < 1e-6);
}

void TestShotComparison::withoutRefinementOrShotNumbers_nothing()
{
    ModelInput input = inputOf({{}, {}}, 1);
    Compared result = compared(input);
    SensorModel unrefined = result.model;
    unrefined.draft.refinement.reset();
    ModelAssessment found;
    found.poles = result.found.poles;
    compareShots(input, unrefined, found, {});
    QVERIFY(found.perShot.empty() && found.perLevel.empty() && !found.homogeneity);
    for (ModelSeries &series : input.series)
        series.shot = 0; // the average
    compareShots(input, result.model, found, {});
    QVERIFY(found.perShot.empty() && !found.homogeneity);
}

void TestShotComparison::stopped_nothingIsJudged()
{
    const ModelInput input = inputOf({{}, {1.0, 1.05 * kF0_Hz}}, 1);
    const Compared result = compared(input);
    std::stop_source source;
    source.request_stop();
    ModelAssessment found;
    found.poles = result.found.poles;
    for (Pole &pole : found.poles)
        pole.flags.clear();
    compareShots(input, result.model, found, {source.get_token(), {}});
    QVERIFY(!found.homogeneity);
    QVERIFY(!isFlagged(found.poles[0]));
}

void TestShotComparison::judgement_saysPoleProbabilityAndRange()
{
    ModelAssessment found;
    QVERIFY(judgeShots(found).empty());
    found.homogeneity = Homogeneity{30123.4, 20.0, 4.0, 0.0005, false};
    for (const double f_Hz : {kUnknown, 30200.0, 29900.0, 30100.0}) {
        LevelPole shot;
        shot.frequency_Hz = f_Hz;
        found.perShot.push_back(shot);
    }
    const Findings findings = judgeShots(found);
    QCOMPARE(findings.size(), std::size_t(1));
    QCOMPARE(findings[0].id, std::string("MOD-010"));
    QVERIFY(findings[0].severity == Severity::Caution);
    const std::string text = english(findings[0].message);
    for (const char *part : {"30.12 kHz", "0.05 %", "29.9 kHz to 30.2 kHz"})
        QVERIFY2(text.find(part) != std::string::npos, text.c_str());
    found.perShot.resize(1); // none could be fitted: no range is invented
    const std::string plain = english(judgeShots(found)[0].message);
    QVERIFY2(plain.find("resonances") == std::string::npos, plain.c_str());
    found.homogeneity->passed = true;
    QVERIFY(judgeShots(found).empty());
}

DYNCAL_TEST(TestShotComparison)
#include "tst_shot_comparison.moc"
