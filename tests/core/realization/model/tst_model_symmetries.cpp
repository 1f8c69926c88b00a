// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the whole way from the records to the assessed model must not depend on: unit of the
// records, unit of time, direction and order of the shots, a constant added; and what it must scale
// with. No truth is needed for these, so they hold in noise and for every number of the model.

#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/order/order_evidence.h"
#include "core/realization/order/order_scan.h"
#include "tests/support/model_inputs.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace dyncal;
using testing::Noise;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr Index kSamples = 240;
constexpr Index kQuiet = 800;
constexpr Index kOrder = 4;
/// The descent ends at a relative decrease of 1e-12 of the cost, some 1e-3 u from the optimum or
/// nearer; both ways there need not end at the same step.
constexpr double kOfDescent = 1e-3; ///< in standard uncertainties
constexpr double kSameUncertainty = 1e-4; ///< relative: the covariance moves with the place

/// Shots of one sensor with two modes, each with its own height, noise and arrival.
ModelInput calibration(std::uint64_t seed = 3)
{
    Noise noise(seed);
    std::vector<ModelSeries> list;
    const double heights[] = {0.8, 1.6, 2.9};
    const ShotLevel levels[] = {ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};
    for (Index shot = 1; shot <= 3; ++shot) {
        const auto i = static_cast<std::size_t>(shot - 1);
        const double sd = 0.004 * (1.0 + 0.3 * static_cast<double>(shot));
        const double first = 0.3 * static_cast<double>(shot);
        const Eigen::VectorXd y = heights[i]
                * (0.9 * testing::sampledStep(30e3, 0.05, kRate_Hz, kSamples, first)
                    + 0.1 * testing::sampledStep(110e3, 0.08, kRate_Hz, kSamples, first))
            + noise.series(kSamples, sd);
        list.push_back(testing::makeSeries(shot, y, kRate_Hz, noise.series(kQuiet, sd)));
        list.back().level = levels[i];
        list.back().step = heights[i];
        list.back().u_baseline = sd / std::sqrt(static_cast<double>(kQuiet));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(list));
}

/// Every length, level and uncertainty in the unit of the values times `factor`.
ModelInput inOtherUnit(ModelInput input, double factor)
{
    for (ModelSeries &series : input.series) {
        series.y *= factor;
        series.noise *= factor;
        series.fullRate *= factor;
        series.noiseSd *= std::abs(factor);
        series.fullRateNoiseSd *= std::abs(factor);
        series.fullRateNoise = noiseCovariance(series.noise, kLargestNoiseModelOrder);
        series.u_baseline *= std::abs(factor);
    }
    return input;
}

/// The same samples, `factor` times further apart.
ModelInput stretched(ModelInput input, double factor)
{
    input.sampleRate_Hz /= factor;
    for (ModelSeries &series : input.series) {
        series.fullRate_Hz /= factor;
        series.filter.rate_Hz /= factor;
        series.first_s *= factor;
    }
    return input;
}

struct Outcome
{
    SensorModel model;
    ModelAssessment assessment;
    OrderSuggestion suggestion;
    OrderEvidence evidence;
};

Outcome outcomeOf(const ModelInput &input, Index order = kOrder)
{
    RealizationSettings settings;
    settings.maxOrder = 12;
    const auto hankel = decomposeHankel(input, settings);
    Outcome outcome;
    testing::RealizedModel realized
        = testing::realizeModel(input, *hankel, order, settings).value();
    outcome.model = std::move(realized.model);
    outcome.assessment = std::move(realized.assessment);
    outcome.suggestion = suggestOrder(input, *hankel);
    outcome.evidence = gatherOrderEvidence(input, *hankel, outcome.suggestion, settings).value();
    return outcome;
}

bool close(double a, double b, double tolerance)
{
    if ((std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance)
        return true;
    qWarning("%.15g and %.15g differ by more than %g", a, b, tolerance);
    return false;
}

bool closeRelative(double a, double b, double tolerance = kSameUncertainty)
{
    return close(a, b, tolerance * std::abs(a));
}

/// Poles, their uncertainties and what is said of them; `time` of b over that of a.
void comparePoles(const Outcome &a, const Outcome &b, double time = 1.0)
{
    QCOMPARE(b.assessment.poles.size(), a.assessment.poles.size());
    QCOMPARE(b.model.refined, a.model.refined);
    QCOMPARE(b.model.uncertaintyMethod, a.model.uncertaintyMethod);
    for (std::size_t i = 0; i < a.assessment.poles.size(); ++i) {
        const Pole &one = a.assessment.poles[i];
        const Pole &other = b.assessment.poles[i];
        QVERIFY(
            close(one.frequency_Hz, other.frequency_Hz * time, kOfDescent * one.u_frequency_Hz));
        QVERIFY(closeRelative(one.u_frequency_Hz, other.u_frequency_Hz * time));
        QVERIFY(close(one.dampingRatio, other.dampingRatio, kOfDescent * one.u_dampingRatio));
        QVERIFY(closeRelative(one.u_dampingRatio, other.u_dampingRatio));
        QVERIFY(closeRelative(one.coverageFactor, other.coverageFactor));
        QCOMPARE(other.poleClass, one.poleClass);
        QCOMPARE(other.flags, one.flags);
    }
}

void compareFindings(const Findings &a, const Findings &b)
{
    QCOMPARE(b.size(), a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        QCOMPARE(b[i].id, a[i].id);
}

void compareVerdicts(const Outcome &one, const Outcome &other)
{
    QVERIFY(closeRelative(one.model.fit_percent, other.model.fit_percent, 1e-9));
    QVERIFY(
        closeRelative(one.model.fitAttainable_percent, other.model.fitAttainable_percent, 1e-9));
    compareFindings(one.model.findings, other.model.findings);
    const ModelAssessment &a = one.assessment;
    const ModelAssessment &b = other.assessment;
    compareFindings(a.findings, b.findings);
    QCOMPARE(b.homogeneity.has_value(), a.homogeneity.has_value());
    QVERIFY(closeRelative(a.homogeneity->statistic, b.homogeneity->statistic, 1e-2));
    QCOMPARE(b.homogeneity->dof, a.homogeneity->dof);
    QCOMPARE(b.secondOrder.has_value(), a.secondOrder.has_value());
    QVERIFY(closeRelative(a.secondOrder->residualToNoise, b.secondOrder->residualToNoise));
    QVERIFY(close(a.secondOrder->zeta, b.secondOrder->zeta, kOfDescent * a.secondOrder->u_zeta));
    QCOMPARE(b.secondOrder->describes, a.secondOrder->describes);
}

const LevelPole *ofShot(const ModelAssessment &assessment, Index shot)
{
    for (const LevelPole &level : assessment.perShot) {
        if (level.shots == std::vector<Index>{shot})
            return &level;
    }
    return nullptr;
}

} // namespace

class TestModelSymmetries : public QObject
{
    Q_OBJECT

private slots:
    void unitOfTheRecords_scalesWhatHasIt_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("mV") << 1e3;
        QTest::newRow("nV") << 1e9;
        QTest::newRow("GV") << 1e-9;
        QTest::newRow("reads backwards") << -1.0;
    }
    void unitOfTheRecords_scalesWhatHasIt()
    {
        QFETCH(double, factor);
        const Outcome volts = outcomeOf(calibration());
        const Outcome other = outcomeOf(inOtherUnit(calibration(), factor));
        const double size = std::abs(factor);
        comparePoles(volts, other);
        compareVerdicts(volts, other);
        QVERIFY(closeRelative(volts.model.plateauGain * factor, other.model.plateauGain));
        for (std::size_t r = 0; r < 3; ++r) {
            const SeriesFit &a = volts.model.series[r];
            const SeriesFit &b = other.model.series[r];
            QVERIFY(
                close(a.plateauGain * factor, b.plateauGain, kOfDescent * size * a.u_plateauGain));
            QVERIFY(closeRelative(a.u_plateauGain * size, b.u_plateauGain));
            QVERIFY(close(a.onset_s, b.onset_s, kOfDescent * a.u_onset_s));
            QVERIFY(closeRelative(a.u_onset_s, b.u_onset_s, 1e-3));
            QVERIFY(closeRelative(a.fit_percent, b.fit_percent, 1e-9));
        }
        for (std::size_t i = 0; i < volts.model.poles.size(); ++i)
            QVERIFY(closeRelative(
                volts.model.poles[i].amplitude * size, other.model.poles[i].amplitude, 1e-3));
        QCOMPARE(other.suggestion.order, volts.suggestion.order);
        QCOMPARE(english(other.suggestion.reason), english(volts.suggestion.reason));
        QCOMPARE(other.evidence.words.size(), volts.evidence.words.size());
        for (std::size_t i = 0; i < volts.evidence.words.size(); ++i)
            QCOMPARE(english(other.evidence.words[i]), english(volts.evidence.words[i]));
    }

    void unitOfTime_scalesFrequenciesAlone_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("1000 times slower") << 1e3;
        QTest::newRow("1000 times faster") << 1e-3;
        QTest::newRow("years") << 3.2e13;
    }
    void unitOfTime_scalesFrequenciesAlone()
    {
        QFETCH(double, factor);
        const Outcome one = outcomeOf(calibration());
        const Outcome slow = outcomeOf(stretched(calibration(), factor));
        comparePoles(one, slow, factor);
        compareVerdicts(one, slow);
        for (std::size_t r = 0; r < 3; ++r) {
            const SeriesFit &a = one.model.series[r];
            const SeriesFit &b = slow.model.series[r];
            QVERIFY(close(a.onset_s * factor, b.onset_s, kOfDescent * factor * a.u_onset_s));
            QVERIFY(closeRelative(a.u_onset_s * factor, b.u_onset_s, 1e-3));
            QVERIFY(closeRelative(a.u_plateauGain, b.u_plateauGain));
        }
        QCOMPARE(slow.suggestion.order, one.suggestion.order);
        QCOMPARE(slow.model.zeros.size(), one.model.zeros.size());
        for (std::size_t i = 0; i < one.model.zeros.size(); ++i) // z plane: without time
            QVERIFY(std::abs(slow.model.zeros[i] - one.model.zeros[i])
                < 1e-3 * (1.0 + std::abs(one.model.zeros[i])));
    }

    void orderOfTheShots_changesNothing()
    {
        const Outcome one = outcomeOf(calibration());
        ModelInput input = calibration();
        std::rotate(input.series.begin(), input.series.begin() + 1, input.series.end());
        const Outcome turned = outcomeOf(input);
        comparePoles(one, turned);
        compareVerdicts(one, turned);
        for (Index shot = 1; shot <= 3; ++shot) {
            const LevelPole &a = *ofShot(one.assessment, shot);
            const LevelPole &b = *ofShot(turned.assessment, shot);
            QVERIFY(close(a.frequency_Hz, b.frequency_Hz, kOfDescent * a.u_frequency_Hz));
            QVERIFY(closeRelative(a.u_plateauGain, b.u_plateauGain));
            QCOMPARE(b.level, a.level);
            QCOMPARE(b.step, a.step);
        }
        QCOMPARE(
            turned.assessment.perLevel.size(), std::size_t(3)); // from low to high all the same
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(turned.assessment.perLevel[i].level, one.assessment.perLevel[i].level);
        QCOMPARE(turned.evidence.crossShots, (std::vector<Index>{2, 3, 1}));
        QVERIFY((turned.evidence.crossShot_percent - one.evidence.crossShot_percent)
                    .cwiseAbs()
                    .maxCoeff()
            < 1e-6);
    }

    void constantAddedToAShot_movesItsPlateauAlone()
    {
        // The level after the step is fitted, so what was subtracted as baseline moves no pole.
        const Outcome one = outcomeOf(calibration());
        ModelInput input = calibration();
        constexpr double kShift = 0.02;
        input.series[1].y.array() += kShift;
        input.series[1].fullRate.array() += kShift;
        const Outcome shifted = outcomeOf(input);
        comparePoles(one, shifted);
        for (std::size_t r = 0; r < 3; ++r) {
            const SeriesFit &a = one.model.series[r];
            const SeriesFit &b = shifted.model.series[r];
            QVERIFY(close(a.plateauGain + (r == 1 ? kShift : 0.0), b.plateauGain,
                kOfDescent * a.u_plateauGain));
            QVERIFY(closeRelative(a.u_plateauGain, b.u_plateauGain));
        }
    }

    void everyShotTwice_uncertaintiesShrinkByTheRoot()
    {
        const ModelInput input = calibration(5);
        const Outcome once = outcomeOf(input);
        ModelInput doubled = input;
        for (ModelSeries series : input.series) {
            series.shot += 3;
            doubled.series.push_back(series);
        }
        const Outcome twice = outcomeOf(doubled);
        // Copies are no independent shots: their disagreement counts twice as well.
        QVERIFY(once.assessment.homogeneity->passed && twice.assessment.homogeneity->passed);
        QVERIFY(closeRelative(2.0 * once.assessment.homogeneity->statistic,
            twice.assessment.homogeneity->statistic, 0.05));
        // chi square over its degrees of freedom, which scales u where it exceeds 1, hardly moves.
        constexpr double kOfFreedom = 0.02;
        for (std::size_t i = 0; i < once.assessment.poles.size(); ++i) {
            const Pole &a = once.assessment.poles[i];
            const Pole &b = twice.assessment.poles[i];
            QVERIFY(close(a.frequency_Hz, b.frequency_Hz, 0.05 * a.u_frequency_Hz));
            QVERIFY(closeRelative(a.u_frequency_Hz / std::sqrt(2.0), b.u_frequency_Hz, kOfFreedom));
            QVERIFY(closeRelative(a.u_dampingRatio / std::sqrt(2.0), b.u_dampingRatio, kOfFreedom));
        }
        // The plateau of each shot is its own: known as well as before, but for the shared poles.
        for (std::size_t r = 0; r < 3; ++r)
            QVERIFY(closeRelative(
                once.model.series[r].u_plateauGain, twice.model.series[r].u_plateauGain, 0.05));
        QVERIFY(closeRelative(once.model.fit_percent, twice.model.fit_percent, 1e-3));
    }

    void oneShot_isToldTheSameInTheSeriesAndInTheTrend()
    {
        // One shot alone: the joint fit is the fit of that shot, and every number in both places
        // is of the same record.
        ModelInput input = calibration();
        input.series.resize(1);
        input.series[0].u_baseline = 0.003; // far more than the noise behind the start leaves
        const Outcome outcome = outcomeOf(input);
        const LevelPole &trend = outcome.assessment.perShot.at(0);
        const SeriesFit &fit = outcome.model.series.at(0);
        const Pole &main = *mainPole(outcome.model, &outcome.assessment);
        QVERIFY(close(fit.plateauGain, trend.plateauGain, kOfDescent * fit.u_plateauGain));
        QVERIFY(closeRelative(fit.u_plateauGain, trend.u_plateauGain, 1e-3));
        QVERIFY(fit.u_plateauGain > input.series[0].u_baseline);
        QVERIFY(closeRelative(main.u_frequency_Hz, trend.u_frequency_Hz, 1e-3));
        QVERIFY(closeRelative(main.coverageFactor, trend.coverageFactor));
    }

    void levelOfSeveralShots_hasTheBaselineOfEach()
    {
        // Two shots of one level whose baselines dominate: u of their mean is that of independent
        // baselines, u/sqrt(2), whatever the noise adds.
        ModelInput input = calibration();
        input.series.erase(input.series.begin() + 2);
        for (ModelSeries &series : input.series) {
            series.level = ShotLevel::Low;
            series.u_baseline = 1.0;
        }
        const ModelAssessment found = outcomeOf(input).assessment;
        QCOMPARE(found.perLevel.size(), std::size_t(1));
        QVERIFY(closeRelative(std::sqrt(0.5), found.perLevel[0].u_plateauGain, 1e-3));
    }

    void freeDecay_hasNoPlateauNorOnset_inAnyUnit()
    {
        Noise noise(8);
        std::vector<ModelSeries> list;
        for (Index shot = 1; shot <= 2; ++shot) {
            Eigen::VectorXd y(kSamples);
            for (Index k = 0; k < kSamples; ++k) {
                const double t_s = static_cast<double>(k) / kRate_Hz;
                y[k] = static_cast<double>(shot) * std::exp(-9e3 * t_s)
                    * std::cos(1.9e5 * t_s + static_cast<double>(shot));
            }
            y += noise.series(kSamples, 0.01);
            list.push_back(testing::makeSeries(shot, y, kRate_Hz, noise.series(kQuiet, 0.01)));
        }
        const ModelInput input
            = testing::makeInput(ResponseTreatment::Impulse, kRate_Hz, std::move(list));
        const Outcome one = outcomeOf(input, 2);
        const Outcome other = outcomeOf(inOtherUnit(input, -1e6), 2);
        comparePoles(one, other);
        for (const Outcome *outcome : {&one, &other}) {
            QCOMPARE(outcome->model.plateauGain, 0.0);
            QVERIFY(!outcome->assessment.secondOrder);
            for (const SeriesFit &fit : outcome->model.series) {
                QCOMPARE(fit.plateauGain, 0.0);
                QCOMPARE(fit.onset_s, 0.0);
                QVERIFY(std::isnan(fit.u_plateauGain));
            }
        }
        // Sizes are the mean over the shots: 1/2 and 2/2 of a cosine.
        QVERIFY(closeRelative(one.model.poles[0].amplitude, 0.75, 0.02));
    }
};

DYNCAL_TEST(TestModelSymmetries)
#include "tst_model_symmetries.moc"
