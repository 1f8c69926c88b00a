// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the frequency response must not depend on, and what it must scale with: whole records as the
// window stage hands them over, with the fits that belong to them.

#include "core/model_analysis/sensor_response.h"
#include "tests/support/model_inputs.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 10e6;
constexpr double kF0_Hz = 300e3;
constexpr double kZeta = 0.05;
constexpr double kOnset_s = -0.25 / kRate_Hz;
constexpr Index kLength = 8000;
constexpr double kSensitivity_V_Pa = 8e-7;
constexpr double kRounding = 1e-11;
/// Sampled 33 times per period; up to the resonance.
constexpr double kAliasing = 2e-3;

struct ShotTruth
{
    Index shot = 1;
    double step_Pa = 5e5;
    double noise = 0.0; ///< of the step
    Index length = kLength;
    double rate_Hz = kRate_Hz;
};

/// Records, fits and steps of one sensor, in volts or divided by the step.
struct Calibration
{
    std::vector<WindowedResponse> responses;
    ModelInput input;
    SensorModel model = testing::secondOrderModel(kF0_Hz, kZeta);
    ShockConditionsSet shock;
    ResponseSettings settings;

    Calibration(const std::vector<ShotTruth> &shots, bool remap, std::uint64_t seed = 1)
    {
        input.sampleRate_Hz = kRate_Hz;
        input.samples = 4000;
        settings.grid = "list";
        settings.frequencies_Hz = {2e3, 3e4, 1e5, 2.9e5, 3.1e5};
        testing::Noise noise(seed);
        for (const ShotTruth &truth : shots)
            add(truth, remap, noise);
    }

    void add(const ShotTruth &truth, bool remap, testing::Noise &noise)
    {
        const double step_V = kSensitivity_V_Pa * truth.step_Pa;
        const double inValues = remap ? 1.0 : step_V;
        WindowedResponse response;
        response.shot = truth.shot;
        response.unit = "V";
        response.sampleRate_Hz = truth.rate_Hz;
        response.step = step_V;
        response.valueScale = remap ? step_V : 1.0;
        response.noiseSd = truth.noise * step_V;
        response.length = truth.length;
        response.values = inValues
            * (testing::sampledStep(
                   kF0_Hz, kZeta, truth.rate_Hz, truth.length, -kOnset_s * truth.rate_Hz)
                + noise.series(truth.length, truth.noise));
        responses.push_back(response);
        SeriesFit fit;
        fit.shot = truth.shot;
        fit.plateauGain = inValues;
        fit.onset_s = kOnset_s;
        fit.u_onset_s = 0.0;
        fit.amplitudes = inValues * model.amplitudes / model.plateauGain;
        model.series.push_back(fit);
        ShockConditions conditions;
        conditions.shot = truth.shot;
        conditions.step_Pa = truth.step_Pa;
        shock.shots.push_back(conditions);
        setModelTo(std::accumulate(model.series.begin(), model.series.end(), 0.0,
                       [](double sum, const SeriesFit &one) { return sum + one.plateauGain; })
            / static_cast<double>(model.series.size()));
    }

    void setModelTo(double plateau)
    {
        model.amplitudes *= plateau / model.plateauGain;
        model.plateauGain = plateau;
    }

    /// One fit of the mean of all records instead of one of each.
    void average()
    {
        SeriesFit mean = model.series.front();
        mean.shot = 0;
        mean.plateauGain = model.plateauGain;
        mean.amplitudes = model.amplitudes;
        model.series = {mean};
    }

    ResponseResult run() const
    {
        return computeResponse(responses, input, model, shock, settings).value();
    }
};

std::complex<double> transferFunction(double f_Hz)
{
    const double r = f_Hz / kF0_Hz;
    return 1.0 / std::complex<double>(1.0 - r * r, 2.0 * kZeta * r);
}

bool same(const Eigen::VectorXd &a, const Eigen::VectorXd &b, double scale = 1.0)
{
    return a.size() == b.size()
        && (a - scale * b).cwiseAbs().maxCoeff() <= kRounding * a.cwiseAbs().maxCoeff();
}

const std::vector<ShotTruth> kLowToHigh{{1, 1e5, 1e-3}, {2, 2.5e5, 1e-3}, {3, 6e5, 1e-3}};

} // namespace

class TestResponseProperties : public QObject
{
    Q_OBJECT

private slots:
    void remapping_changesNoNumber_data()
    {
        QTest::addColumn<bool>("averaged");
        QTest::newRow("stacked") << false;
        QTest::newRow("average") << true;
    }
    void remapping_changesNoNumber()
    {
        // Steps of 1 to 6: an average of volts belongs to none of them, their response does.
        QFETCH(bool, averaged);
        for (const char *reference : {"computed-step", "unit-step"}) {
            Calibration remapped(kLowToHigh, true);
            Calibration volts(kLowToHigh, false);
            for (Calibration *calibration : {&remapped, &volts}) {
                calibration->settings.reference = reference;
                if (averaged)
                    calibration->average();
            }
            const ResponseResult a = remapped.run();
            const ResponseResult b = volts.run();
            QCOMPARE(b.unit, a.unit);
            QVERIFY(same(b.magnitude, a.magnitude));
            QVERIFY(same(b.phase_rad, a.phase_rad));
            QVERIFY(same(b.u_magnitude, a.u_magnitude));
            QVERIFY(same(b.u_phase_rad, a.u_phase_rad));
            QVERIFY(same(b.modelMagnitude, a.modelMagnitude));
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY(std::abs(*b.shots[i].sensitivity / kSensitivity_V_Pa - 1.0) < kRounding);
                QVERIFY(std::abs(*a.shots[i].sensitivity / kSensitivity_V_Pa - 1.0) < kRounding);
            }
            QVERIFY(b.findings.empty());
        }
    }

    void orderOfTheShots_changesNothing()
    {
        Calibration one({{1, 1e5, 1e-3, 8000}, {2, 4e5, 5e-3, 6000}, {3, 3e5, 0.0, 7000}}, true);
        Calibration turned = one;
        std::reverse(turned.responses.begin(), turned.responses.end());
        std::reverse(turned.model.series.begin(), turned.model.series.end());
        std::reverse(turned.shock.shots.begin(), turned.shock.shots.end());
        const ResponseResult a = one.run();
        const ResponseResult b = turned.run();
        QVERIFY(same(a.magnitude, b.magnitude));
        QVERIFY(same(a.u_magnitude, b.u_magnitude));
        QVERIFY(same(a.phase_rad, b.phase_rad));
        QCOMPARE(a.fLow_Hz, b.fLow_Hz);
        QCOMPARE(a.fHigh_Hz, b.fHigh_Hz);
        QVERIFY(std::abs(*a.sensitivity / *b.sensitivity - 1.0) < kRounding);
    }

    void timesStretched_frequenciesShrink()
    {
        const Calibration one({{1, 3e5, 2e-3}}, true);
        constexpr double kTime = 1000.0;
        Calibration slow = one;
        slow.input.sampleRate_Hz /= kTime;
        slow.responses[0].sampleRate_Hz /= kTime;
        slow.model.series[0].onset_s *= kTime;
        for (Pole &pole : slow.model.poles)
            pole.s_rad_s /= kTime;
        for (double &f_Hz : slow.settings.frequencies_Hz)
            f_Hz /= kTime;
        const ResponseResult a = one.run();
        const ResponseResult b = slow.run();
        QVERIFY(same(b.magnitude, a.magnitude));
        QVERIFY(same(b.u_magnitude, a.u_magnitude));
        QVERIFY(same(b.phase_rad, a.phase_rad));
        QVERIFY(same(b.modelPhase_rad, a.modelPhase_rad));
        QVERIFY(std::abs(b.fHigh_Hz * kTime / a.fHigh_Hz - 1.0) < kRounding);
        QVERIFY(
            std::abs(*b.characteristics.riseTime_s / kTime / *a.characteristics.riseTime_s - 1.0)
            < kRounding);
    }

    void shotsOfOtherRatesAndLengths_haveTheSameSensor()
    {
        const Calibration calibration(
            {{1, 1e5, 0.0, 8000, 10e6}, {2, 2e5, 0.0, 30000, 25e6}}, true);
        const ResponseResult result = calibration.run();
        for (Index k = 0; k < result.frequency_Hz.size(); ++k) {
            const std::complex<double> G
                = kSensitivity_V_Pa * transferFunction(result.frequency_Hz[k]);
            QVERIFY(std::abs(result.magnitude[k] / std::abs(G) - 1.0) < kAliasing);
            QVERIFY(std::abs(result.phase_rad[k] - std::arg(G)) < kAliasing);
        }
        QVERIFY(std::abs(result.fLow_Hz - 1.25e3) < 1e-6); // 0.8 ms is the shorter one
        QVERIFY(std::abs(result.fHigh_Hz - 4e6) < 1.0); // 0.4 of the slower one
    }

    void statedUncertainties_areTheScatterOfTheRecords()
    {
        // Two shots of different noise, 200 times; plateau and onset are known here, so the noise
        // of the samples is all there is.
        constexpr int kTrials = 200;
        const std::vector<ShotTruth> shots{{1, 2e5, 4e-3, 6000}, {2, 5e5, 1e-2, 6000}};
        const ResponseResult clean
            = Calibration({{1, 2e5, 0.0, 6000}, {2, 5e5, 0.0, 6000}}, true).run();
        Eigen::ArrayXd magnitude = Eigen::ArrayXd::Zero(5);
        Eigen::ArrayXd phase = Eigen::ArrayXd::Zero(5);
        for (int trial = 0; trial < kTrials; ++trial) {
            const ResponseResult noisy
                = Calibration(shots, true, static_cast<std::uint64_t>(trial + 1)).run();
            magnitude
                += ((noisy.magnitude - clean.magnitude).array() / noisy.u_noiseMagnitude.array())
                       .square()
                / kTrials;
            phase += ((noisy.phase_rad - clean.phase_rad).array() / noisy.u_noisePhase_rad.array())
                         .square()
                / kTrials;
        }
        // A mean of 200 squares scatters by 10 %; three times that over ten of them.
        for (const Eigen::ArrayXd &squares : {magnitude, phase}) {
            for (Index k = 0; k < 5; ++k)
                QVERIFY2(
                    squares[k] > 0.65 && squares[k] < 1.4, qPrintable(QString::number(squares[k])));
        }
    }

    void frequenciesTheRecordsDoNotHold_haveNoMeasuredValue()
    {
        // S(f) of samples repeats itself beyond half the rate: a number there would look like any.
        Calibration calibration(kLowToHigh, true);
        calibration.settings.frequencies_Hz = {1e5, 0.4 * kRate_Hz, 0.41 * kRate_Hz, 0.5 * kRate_Hz,
            kRate_Hz, kRate_Hz + 1e5, 3.0 * kRate_Hz};
        const ResponseResult result = calibration.run();
        for (const Index k : {0, 1})
            QVERIFY(std::isfinite(result.magnitude[k]) && std::isfinite(result.u_phase_rad[k]));
        for (Index k = 2; k < 7; ++k) {
            QVERIFY(std::isnan(result.magnitude[k]) && std::isnan(result.u_magnitude[k]));
            QVERIFY(std::isnan(result.phase_rad[k]) && std::isnan(result.u_phase_rad[k]));
            // The model has one: it is continuous.
            const double expected
                = kSensitivity_V_Pa * std::abs(transferFunction(result.frequency_Hz[k]));
            QVERIFY(std::abs(result.modelMagnitude[k] / expected - 1.0) < 1e-6);
        }
        // The slowest record of all decides.
        Calibration mixed({{1, 1e5, 0.0, 8000, 10e6}, {2, 2e5, 0.0, 8000, 40e6}}, true);
        mixed.settings.frequencies_Hz = {1e5, 6e6};
        QVERIFY(std::isnan(mixed.run().magnitude[1]));
    }

    void veryLowFrequencies_areThePlateau()
    {
        Calibration calibration({{1, 3e5, 1e-3}}, true);
        calibration.settings.frequencies_Hz = {1e-300, 1e-3, 1.0};
        const ResponseResult result = calibration.run();
        for (Index k = 0; k < 3; ++k) {
            QVERIFY(std::abs(result.magnitude[k] / kSensitivity_V_Pa - 1.0) < 1e-3);
            QVERIFY(std::abs(result.phase_rad[k]) < 1e-3);
            QVERIFY(std::abs(result.modelMagnitude[k] / kSensitivity_V_Pa - 1.0) < 1e-6);
        }
    }

    void recordOfOneSample_isNeitherReadBeyondNorACrash()
    {
        for (const Index length : {1, 2, 3}) {
            Calibration calibration({{1, 3e5, 1e-3, length}}, true);
            calibration.settings.grid = "third-octave";
            const ResponseResult result = calibration.run();
            QVERIFY(result.fLow_Hz > 0.0);
            QVERIFY(*result.sensitivity > 0.0);
        }
    }

    void notFiniteRecord_neverGivesANumber()
    {
        for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
            Calibration calibration({{1, 3e5, 1e-3}, {2, 3e5, 1e-3}}, true);
            calibration.responses[1].values[100] = bad;
            const ResponseResult result = calibration.run();
            for (Index k = 0; k < result.magnitude.size(); ++k)
                QVERIFY(!std::isfinite(result.magnitude[k]));
        }
    }

    void modelAlone_saysWhatTheWholeResponseSays()
    {
        const Calibration calibration(kLowToHigh, true);
        const ResponseResult whole = calibration.run();
        const ResponseResult quick
            = computeModelResponse(calibration.responses, calibration.input, calibration.model,
                calibration.shock, calibration.settings, whole.fLow_Hz, whole.fHigh_Hz);
        QVERIFY(same(quick.modelCurve.magnitude, whole.modelCurve.magnitude));
        QVERIFY(same(quick.modelCurve.phase_rad, whole.modelCurve.phase_rad));
        QCOMPARE(quick.unit, whole.unit);
        QCOMPARE(*quick.sensitivity, *whole.sensitivity);
        QCOMPARE(quick.magnitude.size(), Index(0)); // nothing is taken from the records
    }
};

DYNCAL_TEST(TestResponseProperties)
#include "tst_response_properties.moc"
