// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/sensor_response.h"
#include "core/model_analysis/step_transform.h"
#include "tests/support/cascade_model.h"
#include "tests/support/model_inputs.h"
#include "tests/support/second_order_model.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <numbers>

using namespace dyncal;
using testing::hasFinding;

namespace {

constexpr double kRate_Hz = 10e6;
constexpr double kF0_Hz = 300e3;
constexpr double kZeta = 0.05;
constexpr double kOnset_s = -0.5 / kRate_Hz;
constexpr Index kLead = 100;
constexpr Index kLength = 20000; ///< 2 ms: the band begins at 500 Hz
constexpr double kStep_V = 0.4;
constexpr double kStep_Pa = 5e5;
constexpr double kRounding = 1e-12;
/// Aliasing of a second-order response sampled 33 times per period, up to twice its resonance.
constexpr double kAliasing = 2e-3;

/// Noise-free response of a model, remapped to a plateau of 1.
WindowedResponse responseOf(const SensorModel &model, Index shot, Index length = kLength)
{
    WindowedResponse response;
    response.shot = shot;
    response.channel = "DUT";
    response.unit = "V";
    response.sampleRate_Hz = kRate_Hz;
    response.step = response.valueScale = kStep_V;
    response.lead = kLead;
    response.length = length;
    response.values = Eigen::VectorXd::Zero(kLead + length);
    for (Index k = 0; k < length; ++k) {
        const double t_s = static_cast<double>(k) / kRate_Hz - kOnset_s;
        std::complex<double> y = model.plateauGain;
        for (Index i = 0; i < model.order; ++i)
            y += model.amplitudes[i]
                * std::exp(model.poles[static_cast<std::size_t>(i)].s_rad_s * t_s);
        response.values[kLead + k] = y.real();
    }
    return response;
}

/// One calibration written down by hand: every shot shows the same sensor.
struct Calibration
{
    std::vector<WindowedResponse> responses;
    ModelInput input;
    SensorModel model;
    ShockConditionsSet shock;
    ResponseSettings settings;

    explicit Calibration(const SensorModel &truth, Index shots = 1)
        : model(truth)
    {
        input.sampleRate_Hz = kRate_Hz;
        input.samples = 4000;
        settings.grid = "list";
        settings.frequencies_Hz = {1e3, 3e4, 1e5, 2.9e5, 3.1e5, 6e5};
        for (Index shot = 1; shot <= shots; ++shot) {
            responses.push_back(responseOf(truth, shot));
            SeriesFit fit;
            fit.shot = shot;
            fit.plateauGain = 1.0;
            fit.onset_s = kOnset_s;
            fit.u_onset_s = 0.0;
            fit.amplitudes = truth.amplitudes;
            model.series.push_back(fit);
            ShockConditions conditions;
            conditions.shot = shot;
            conditions.step_Pa = kStep_Pa;
            shock.shots.push_back(conditions);
        }
    }

    ResponseResult run() const
    {
        return computeResponse(responses, input, model, shock, settings).value();
    }
};

Calibration secondOrder(Index shots = 1)
{
    return Calibration(testing::secondOrderModel(kF0_Hz, kZeta), shots);
}

std::complex<double> transferFunction(double f_Hz)
{
    const double r = f_Hz / kF0_Hz;
    return 1.0 / std::complex<double>(1.0 - r * r, 2.0 * kZeta * r);
}

} // namespace

class TestSensorResponse : public QObject
{
    Q_OBJECT

private slots:
    void onsetOfUnknownUncertainty_leavesThePhaseWithoutOne()
    {
        Calibration calibration = secondOrder();
        calibration.model.series.front().u_onset_s = kUnknown;
        const ResponseResult result = calibration.run();
        QVERIFY(result.magnitude.head(3).allFinite() && result.u_magnitude.head(3).allFinite());
        QVERIFY(result.phase_rad.head(3).allFinite());
        QVERIFY(result.u_phase_rad.array().isNaN().all());
    }

    void sensitivity_isTheStepReadOverThePressureStep()
    {
        Calibration calibration = secondOrder(2);
        calibration.responses[1].step = calibration.responses[1].valueScale = 0.6;
        calibration.shock.shots[1].step_Pa = 6e5;
        calibration.model.series[1].plateauGain = 1.01; // the settle band read 1 % too little
        calibration.responses[1].values *= 1.01;
        const ResponseResult result = calibration.run();
        const double first = kStep_V / kStep_Pa;
        const double second = 1.01 * 0.6 / 6e5;
        QCOMPARE(result.shots.size(), std::size_t(2));
        QVERIFY(std::abs(*result.shots[0].sensitivity / first - 1.0) < kRounding);
        QVERIFY(std::abs(*result.shots[1].sensitivity / second - 1.0) < kRounding);
        QVERIFY(std::abs(*result.sensitivity / (0.5 * (first + second)) - 1.0) < kRounding);
        QCOMPARE(result.unit, std::string("V/Pa"));
        QCOMPARE(result.sensitivityUnit, std::string("V/Pa"));
        QVERIFY(std::abs(second / first - 1.0)
            > 0.1); // so the shots disagree, and nothing else is said
        QCOMPARE(result.findings.size(), std::size_t(1));
        QCOMPARE(result.findings.front().id, std::string("RSP-002"));
    }

    void negativeStep_givesANegativeSensitivity_andAPositiveMagnitude()
    {
        Calibration calibration = secondOrder();
        calibration.responses[0].step = calibration.responses[0].valueScale = -kStep_V;
        const ResponseResult result = calibration.run();
        QVERIFY(std::abs(*result.sensitivity / (-kStep_V / kStep_Pa) - 1.0) < kRounding);
        QVERIFY(result.magnitude.minCoeff() > 0.0);
    }

    void invertedSensor_isHalfATurnFromTheUpright()
    {
        Calibration calibration = secondOrder();
        const ResponseResult upright = calibration.run();
        calibration.responses[0].step = calibration.responses[0].valueScale = -kStep_V;
        const ResponseResult inverted = calibration.run();
        QVERIFY(!hasFinding(inverted.findings, "RSP-001"));
        const auto isNear = [](const Eigen::VectorXd &a, const Eigen::VectorXd &b) {
            return a.size() == b.size() && (a - b).cwiseAbs().maxCoeff() < kRounding;
        };
        const auto turned = [](const Eigen::VectorXd &phase_rad) {
            return Eigen::VectorXd(phase_rad.array() + std::numbers::pi);
        };
        QVERIFY(isNear(inverted.magnitude, upright.magnitude));
        QVERIFY(isNear(inverted.modelMagnitude, upright.modelMagnitude));
        QVERIFY(isNear(inverted.modelCurve.magnitude, upright.modelCurve.magnitude));
        QVERIFY(isNear(inverted.modelPhase_rad, turned(upright.modelPhase_rad)));
        QVERIFY(isNear(inverted.modelCurve.phase_rad, turned(upright.modelCurve.phase_rad)));
        QVERIFY(isNear(inverted.phase_rad, turned(upright.phase_rad)));
        const ResponseResult ofModel
            = computeModelResponse(calibration.responses, calibration.input, calibration.model,
                calibration.shock, calibration.settings, inverted.fLow_Hz, inverted.fHigh_Hz);
        QVERIFY(ofModel.modelCurve.magnitude.minCoeff() > 0.0);
    }

    void sensitivity_withoutAPressureStep_isNotDetermined()
    {
        Calibration calibration = secondOrder(2);
        calibration.shock.shots[1].step_Pa.reset();
        const ResponseResult result = calibration.run();
        QVERIFY(result.shots[0].sensitivity.has_value());
        QVERIFY(!result.shots[1].sensitivity);
        QVERIFY(!result.sensitivity); // no mean over a part of the shots
        QCOMPARE(result.unit, std::string("1"));
        QVERIFY(std::abs(result.magnitude[0] - std::abs(transferFunction(1e3))) < kAliasing);
        calibration.shock.shots.clear();
        QVERIFY(!calibration.run().shots[0].sensitivity);
    }

    void unitsThatDiffer_areSaid_andNotAveraged()
    {
        Calibration calibration = secondOrder(2);
        calibration.responses[1].unit = "mV";
        const ResponseResult result = calibration.run();
        QVERIFY(hasFinding(result.findings, "CAP-023"));
        QVERIFY(!result.sensitivity);
        QCOMPARE(result.shots[0].unit, std::string("V/Pa"));
        QCOMPARE(result.shots[1].unit, std::string("mV/Pa"));
        QCOMPARE(result.unit, std::string("1"));
        QVERIFY(!hasFinding(secondOrder(2).run().findings, "CAP-023"));
    }

    void nonParametric_equalsTheModel_onNoiseFreeData()
    {
        Calibration calibration = secondOrder(3);
        const ResponseResult result = calibration.run();
        QCOMPARE(result.frequency_Hz.size(), Index(6));
        for (Index k = 0; k < 6; ++k) {
            const std::complex<double> G
                = transferFunction(result.frequency_Hz[k]) * (kStep_V / kStep_Pa);
            QVERIFY(std::abs(result.modelMagnitude[k] / std::abs(G) - 1.0) < 1e-9);
            QVERIFY(std::abs(result.modelPhase_rad[k] - std::arg(G)) < 1e-9);
            QVERIFY2(std::abs(result.magnitude[k] / std::abs(G) - 1.0) < kAliasing,
                qPrintable(QString::number(result.magnitude[k] / std::abs(G) - 1.0)));
            QVERIFY(std::abs(result.phase_rad[k] - std::arg(G)) < kAliasing);
            QCOMPARE(result.u_noiseMagnitude[k], 0.0);
        }
        QVERIFY(!hasFinding(result.findings, "RSP-001"));
    }

    void averagedInput_usesTheOneFitForEveryShot()
    {
        Calibration calibration = secondOrder(2);
        calibration.model.series.resize(1);
        calibration.model.series[0].shot = 0;
        const ResponseResult result = calibration.run();
        QVERIFY(result.shots[1].sensitivity.has_value());
        QVERIFY(std::abs(*result.sensitivity / (kStep_V / kStep_Pa) - 1.0) < kRounding);
    }

    void uncertainty_fallsWithTheRootOfTheShots()
    {
        Calibration one = secondOrder(1);
        Calibration four = secondOrder(4);
        for (Calibration *calibration : {&one, &four}) {
            for (WindowedResponse &response : calibration->responses)
                response.noiseSd = 1e-4 * kStep_V;
        }
        const Eigen::VectorXd u1 = one.run().u_noiseMagnitude;
        const ResponseResult result = four.run();
        const Eigen::ArrayXd u4 = result.u_noiseMagnitude.array();
        QVERIFY((u1.array() / u4 - 2.0).abs().maxCoeff() < 1e-9);
        // u of the phase is that of the magnitude, relative; the onset's is not known here.
        const Eigen::ArrayXd relative = u4 / result.magnitude.array();
        QVERIFY((result.u_noisePhase_rad.array() / relative - 1.0).abs().maxCoeff() < 1e-9);
    }

    void bounds_areInTheUncertainty_andBesideIt()
    {
        Calibration calibration = secondOrder();
        for (WindowedResponse &response : calibration.responses)
            response.noiseSd = 1e-7 * kStep_V; // hides no bound
        const ResponseResult result = calibration.run();
        const Eigen::ArrayXd bounds
            = (result.boundEnd.array().square() + result.boundAlias.array().square()) / 3.0;
        const Eigen::ArrayXd noise = result.u_noiseMagnitude.array();
        const Eigen::ArrayXd u = result.u_magnitude.array();
        QVERIFY(((noise.square() + bounds).sqrt() / u - 1.0).abs().maxCoeff() < 1e-12);
        const Eigen::ArrayXd phase
            = result.u_noisePhase_rad.array().square() + bounds / result.magnitude.array().square();
        QVERIFY((phase.sqrt() / result.u_phase_rad.array() - 1.0).abs().maxCoeff() < 1e-12);
        QVERIFY(result.boundAlias.minCoeff() > 0.0);
    }

    void magnitude_takesNothingFromTheModel()
    {
        Calibration calibration = secondOrder(3);
        testing::Noise noise(3);
        for (WindowedResponse &response : calibration.responses) {
            response.noiseSd = 1e-3 * kStep_V;
            response.values += noise.series(response.values.size(), 1e-3);
        }
        for (const char *reference : {"computed-step", "unit-step"}) {
            calibration.settings.reference = reference;
            const ResponseResult right = calibration.run();
            Calibration wrong = calibration;
            wrong.model = testing::secondOrderModel(200e3, 0.3);
            wrong.model.series = calibration.model.series;
            for (SeriesFit &fit : wrong.model.series) {
                fit.plateauGain *= 1.3;
                fit.amplitudes *= -0.2;
                fit.onset_s += 0.4e-6;
            }
            const ResponseResult other = wrong.run();
            QVERIFY(
                (other.magnitude.array() / right.magnitude.array() - 1.0).abs().maxCoeff() < 1e-12);
            QVERIFY((other.boundEnd - right.boundEnd).norm() <= 1e-12 * right.magnitude.norm());
            QVERIFY(other.u_noiseMagnitude == right.u_noiseMagnitude);
            for (Index k = 0; k < right.frequency_Hz.size(); ++k)
                QVERIFY(std::abs(std::remainder(other.phase_rad[k] - right.phase_rad[k]
                                - 2.0 * std::numbers::pi * 0.4e-6 * right.frequency_Hz[k],
                            2.0 * std::numbers::pi))
                    < 1e-9);
        }
    }

    void whatTheEndMayChange_isWithheld_andSaid()
    {
        // 20 kHz, zeta 0.0005, still rings on at the end of 2 ms.
        Calibration calibration(testing::secondOrderModel(20e3, 0.0005));
        calibration.settings.frequencies_Hz = {1e3, 1.9e4, 2.1e4, 1e5};
        const ResponseResult result = calibration.run();
        QVERIFY(hasFinding(result.findings, "RSP-003"));
        QVERIFY(!hasFinding(result.findings, "RSP-001")); // nothing is compared
        for (const Index k : {1, 2}) {
            QCOMPARE(int(result.withheld[std::size_t(k)]), int(WithheldReason::End));
            QVERIFY(std::isnan(result.magnitude[k]) && std::isnan(result.u_magnitude[k]));
            QVERIFY(std::isnan(result.phase_rad[k]) && std::isnan(result.u_phase_rad[k]));
            QVERIFY(result.boundEnd[k] > 0.02 * result.modelMagnitude[k]);
        }
        const Finding &finding = result.findings.front();
        QCOMPARE(int(finding.severity), int(Severity::Info));
        QVERIFY(english(finding.message).find("of 4 frequencies, from") != std::string::npos);
        QVERIFY(!hasFinding(secondOrder().run().findings, "RSP-003"));
    }

    void whatSamplingMayChange_isWithheld_andSaid()
    {
        Calibration calibration(testing::secondOrderModel(4.6e6, 0.02)); // at 10 MS/s
        calibration.settings.frequencies_Hz = {1e3, 1e4, 1e6, 3e6};
        const ResponseResult result = calibration.run();
        QVERIFY(hasFinding(result.findings, "RSP-004"));
        QCOMPARE(int(result.withheld[0]), int(WithheldReason::None));
        QCOMPARE(int(result.withheld[3]), int(WithheldReason::Alias));
        QVERIFY(result.boundAlias[3] > result.boundEnd[3]);
    }

    void statedUncertainty_isTheScatter_atLowFrequencies()
    {
        constexpr int kTrials = 300;
        constexpr double kNoise = 0.01;
        Calibration calibration = secondOrder();
        calibration.settings.frequencies_Hz = {510.0, 800.0, 1300.0, 5e3};
        const Eigen::VectorXd clean = calibration.responses[0].values;
        const Eigen::ArrayXd truth = calibration.run().magnitude.array();
        Eigen::ArrayXd squares = Eigen::ArrayXd::Zero(4);
        testing::Noise noise(5);
        for (int trial = 0; trial < kTrials; ++trial) {
            WindowedResponse &response = calibration.responses[0];
            const Eigen::VectorXd added = noise.series(clean.size(), kNoise);
            response.values = clean + added;
            response.noiseSd = kNoise * kStep_V;
            const ResponseResult result = calibration.run();
            squares
                += ((result.magnitude.array() - truth) / result.u_noiseMagnitude.array()).square();
        }
        const Eigen::ArrayXd rms = (squares / kTrials).sqrt();
        qInfo("rms of error over u: %.2f %.2f %.2f %.2f", rms[0], rms[1], rms[2], rms[3]);
        // The level's part has a direction of its own in the plane: at most sqrt 2 too much is
        // said.
        QVERIFY(rms.maxCoeff() < 1.15 && rms.minCoeff() > 0.6);
    }

    void phase_isUnwrapped_throughTwoResonances()
    {
        Calibration calibration(testing::cascadeModel({{1e5, 0.03}, {3e5, 0.03}}));
        calibration.settings.frequencies_Hz = {5e3, 9e4, 2e5, 4e5, 7e5};
        const ResponseResult result = calibration.run();
        double before = 0.0;
        for (Index k = 0; k < result.frequency_Hz.size(); ++k) {
            const double f_Hz = result.frequency_Hz[k];
            double truth = 0.0; // each factor's own phase never leaves 0..-pi
            for (const double f0_Hz : {1e5, 3e5})
                truth -= std::atan2(0.06 * f_Hz / f0_Hz, 1.0 - std::pow(f_Hz / f0_Hz, 2));
            QVERIFY2(std::abs(result.modelPhase_rad[k] - truth) < 1e-6,
                qPrintable(QString::number(result.modelPhase_rad[k] - truth)));
            QVERIFY2(std::abs(result.phase_rad[k] - truth) < 0.02,
                qPrintable(QString::number(result.phase_rad[k] - truth)));
            QVERIFY(result.modelPhase_rad[k] < before);
            before = result.modelPhase_rad[k];
        }
        QVERIFY(before < -1.5 * std::numbers::pi);
    }

    void modeMissingInTheModel_isSaid()
    {
        const SensorModel truth = testing::cascadeModel({{1e5, 0.03}, {3e5, 0.03}});
        Calibration calibration(truth);
        calibration.settings.frequencies_Hz = {1e3, 5e4, 2.9e5, 3e5};
        QVERIFY(!hasFinding(calibration.run().findings, "RSP-001"));
        const std::vector<SeriesFit> series = calibration.model.series;
        calibration.model = testing::secondOrderModel(1e5, 0.03);
        calibration.model.series = series;
        for (SeriesFit &fit : calibration.model.series)
            fit.amplitudes.conservativeResize(static_cast<Index>(calibration.model.poles.size()));
        const ResponseResult result = calibration.run();
        QVERIFY(hasFinding(result.findings, "RSP-001"));
        const Finding &finding = result.findings.front();
        QVERIFY(*finding.value > *finding.limit);
    }

    void noise_isNotTakenForAMissingMode()
    {
        Calibration calibration = secondOrder();
        calibration.settings.grid = "third-octave";
        testing::Noise noise(11);
        WindowedResponse &response = calibration.responses[0];
        response.noiseSd = 2e-3 * kStep_V;
        response.values += noise.series(response.values.size(), 2e-3);
        const ResponseResult result = calibration.run();
        QVERIFY(result.frequency_Hz.size() > 10);
        QVERIFY(!hasFinding(result.findings, "RSP-001"));
    }

    void list_isKeptAsGiven()
    {
        Calibration calibration = secondOrder();
        const ResponseResult result = calibration.run();
        for (std::size_t k = 0; k < calibration.settings.frequencies_Hz.size(); ++k)
            QCOMPARE(
                result.frequency_Hz[static_cast<Index>(k)], calibration.settings.frequencies_Hz[k]);
    }

    void frequencyBelowTheBand_isSaid_data()
    {
        QTest::addColumn<double>("lowest_Hz");
        QTest::addColumn<bool>("said");
        QTest::newRow("at 1/T") << 500.0 << false; // kLength samples are 2 ms
        QTest::newRow("just below") << 499.9 << true;
        QTest::newRow("far below") << 10.0 << true;
    }

    void frequencyBelowTheBand_isSaid()
    {
        QFETCH(double, lowest_Hz);
        QFETCH(bool, said);
        Calibration calibration = secondOrder(2);
        calibration.responses[1]
            = responseOf(calibration.model, 2, 2 * kLength); // not the shortest
        calibration.settings.frequencies_Hz = {1e4, lowest_Hz, 1e5};
        const ResponseResult result = calibration.run();
        QCOMPARE(hasFinding(result.findings, "WIN-005"), said);
        if (!said)
            return;
        const Finding &finding = result.findings.front();
        QCOMPARE(*finding.value, lowest_Hz);
        QCOMPARE(*finding.limit, 500.0);
        QVERIFY(
            english(finding.message).find("2 ms, resolves steps of 500 Hz") != std::string::npos);
    }

    void grids_neverGoBelowTheBand()
    {
        Calibration calibration = secondOrder();
        for (const char *grid : {"third-octave", "linear"}) {
            calibration.settings.grid = grid;
            QVERIFY(!hasFinding(calibration.run().findings, "WIN-005"));
        }
    }

    void thirdOctaves_areThePreferredFrequenciesInsideTheBand()
    {
        Calibration calibration = secondOrder();
        calibration.settings.grid = "third-octave";
        const ResponseResult result = calibration.run();
        const Eigen::VectorXd &f = result.frequency_Hz;
        QVERIFY(f[0] >= result.fLow_Hz && f[f.size() - 1] <= result.fHigh_Hz);
        QVERIFY(std::abs(f[0] / std::pow(10.0, 2.7) - 1.0) < kRounding); // 501 Hz, band from 500
        for (Index k = 1; k < f.size(); ++k)
            QVERIFY(std::abs(f[k] / f[k - 1] / std::pow(10.0, 0.1) - 1.0) < kRounding);
        QVERIFY(f[f.size() - 1] * std::pow(10.0, 0.1) > result.fHigh_Hz);
    }

    void linearGrid_dividesTheBandEvenly()
    {
        Calibration calibration = secondOrder();
        calibration.settings.grid = "linear";
        calibration.settings.linearCount = 40;
        const ResponseResult result = calibration.run();
        const Eigen::VectorXd &f = result.frequency_Hz;
        QCOMPARE(f.size(), Index(40));
        const double step_Hz = (result.fHigh_Hz - result.fLow_Hz) / 40.0;
        QVERIFY(std::abs(f[39] - result.fHigh_Hz) < 1e-9 * result.fHigh_Hz);
        for (Index k = 1; k < 40; ++k)
            QVERIFY(std::abs(f[k] - f[k - 1] - step_Hz) < 1e-9 * result.fHigh_Hz);
        QVERIFY(std::abs(f[0] - result.fLow_Hz - step_Hz) < 1e-9 * result.fHigh_Hz);
    }

    void lowerLimit_isOneOverTheShortestWindow()
    {
        Calibration calibration = secondOrder(2);
        QVERIFY(std::abs(calibration.run().fLow_Hz / 500.0 - 1.0) < kRounding);
        calibration.responses[1].length = 8000;
        QVERIFY(std::abs(calibration.run().fLow_Hz / 1250.0 - 1.0) < kRounding);
    }

    void upperLimit_withoutNoise_isFourTenthsOfTheLowestRate()
    {
        Calibration calibration = secondOrder();
        QVERIFY(std::abs(calibration.run().fHigh_Hz / (0.4 * kRate_Hz) - 1.0) < kRounding);
    }

    void upperLimit_isWhereTheNoiseTakesOver()
    {
        Calibration calibration = secondOrder();
        constexpr double kNoise = 1e-3;
        calibration.responses[0].noiseSd = kNoise * kStep_V;
        const double limit_Hz = calibration.run().fHigh_Hz;
        const auto share = [&](double f_Hz) {
            const double asked = kRate_Hz * std::max(4000 / kRate_Hz, 20.0 / f_Hz);
            const Index used = kLead + static_cast<Index>(std::ceil(asked)); // all of the lead
            const double variance = stepTransformVariance(
                {used, used / 10, 0.0}, kRate_Hz, kNoise * kNoise, kNoise * kNoise, f_Hz);
            return std::sqrt(variance / (std::norm(transferFunction(f_Hz)) - variance));
        };
        QVERIFY(limit_Hz > kF0_Hz && limit_Hz < 0.3 * kRate_Hz);
        QVERIFY2(share(limit_Hz) <= 0.1, qPrintable(QString::number(share(limit_Hz))));
        QVERIFY(share(limit_Hz * std::pow(10.0, 0.1)) > 0.1);
    }

    void freeDecay_hasAModelCurve_andNothingFromAStep()
    {
        Calibration calibration = secondOrder();
        calibration.input.treatment = ResponseTreatment::Impulse;
        const ResponseResult result = calibration.run();
        QCOMPARE(result.magnitude.size(), Index(0));
        QCOMPARE(result.u_magnitude.size(), Index(0));
        QVERIFY(result.shots.empty() && !result.sensitivity);
        QVERIFY(!result.characteristics.riseTime_s);
        QCOMPARE(result.unit, std::string("1"));
        QCOMPARE(result.modelMagnitude.size(), Index(6));
    }

    void freeDecay_endsAtHalfTheRateOfTheModel()
    {
        // Nothing measured stands beside the model, and above half its rate it says nothing.
        Calibration calibration = secondOrder();
        calibration.input.treatment = ResponseTreatment::Impulse;
        calibration.input.sampleRate_Hz = 1e6;
        const ResponseResult listed = calibration.run();
        QVERIFY(std::abs(listed.fHigh_Hz / 5e5 - 1.0) < kRounding);
        QVERIFY(std::isfinite(listed.modelMagnitude[4]) && std::isfinite(listed.modelPhase_rad[4]));
        QVERIFY(std::isnan(listed.modelMagnitude[5]) && std::isnan(listed.modelPhase_rad[5]));
        QVERIFY(listed.modelCurve.frequency_Hz.maxCoeff() <= 5e5 * (1.0 + kRounding));
        for (const char *grid : {"third-octave", "linear"}) {
            calibration.settings.grid = grid;
            const ResponseResult result = calibration.run();
            QVERIFY(result.frequency_Hz.size() > 5);
            QVERIFY(result.frequency_Hz.maxCoeff() <= 5e5 * (1.0 + kRounding));
            QVERIFY(result.modelMagnitude.allFinite());
        }
    }

    void limitsOfTheAnswers_areThoseOfRecordsAndModel()
    {
        Calibration calibration = secondOrder();
        calibration.input.sampleRate_Hz = 0.25 * kRate_Hz;
        ResponseResult result = calibration.run();
        QVERIFY(std::abs(result.modelLimit_Hz / (0.125 * kRate_Hz) - 1.0) < kRounding);
        QVERIFY(std::abs(result.fHigh_Hz / (0.4 * kRate_Hz) - 1.0) < kRounding); // of the records
        QVERIFY(std::abs(result.resolution_s * 0.25 * kRate_Hz - 1.0) < kRounding);
        QVERIFY(std::abs(result.window_s * result.fLow_Hz - 1.0) < kRounding);
        calibration.model.refined = true; // on the records themselves
        result = calibration.run();
        QVERIFY(std::abs(result.resolution_s * kRate_Hz - 1.0) < kRounding);
    }

    void gap_saysWhyThereAreNoCharacteristics()
    {
        Calibration calibration = secondOrder();
        QCOMPARE(int(calibration.run().gap), int(CharacteristicsGap::None));
        calibration.model.series[0].u_plateauGain = 0.2;
        QCOMPARE(int(calibration.run().gap), int(CharacteristicsGap::LevelUnknown));
        calibration.model.diverges = true;
        QCOMPARE(int(calibration.run().gap), int(CharacteristicsGap::Diverges));
        calibration.input.treatment = ResponseTreatment::Impulse;
        QCOMPARE(int(calibration.run().gap), int(CharacteristicsGap::FreeDecay));
    }

    void divergingModel_givesNoResponse()
    {
        Calibration calibration = secondOrder();
        calibration.model.diverges = true;
        const ResponseResult result = calibration.run();
        QCOMPARE(result.magnitude.size(), Index(0));
        QCOMPARE(result.modelMagnitude.size(), Index(0));
        QCOMPARE(result.modelCurve.magnitude.size(), Index(0));
        QVERIFY(!result.sensitivity && !result.shots[0].sensitivity);
        QVERIFY(!result.characteristics.minus3dB_Hz);
    }

    void otherReferences_areRelative()
    {
        Calibration calibration = secondOrder();
        for (const char *reference : {"unit-step", "static-sensitivity"}) {
            calibration.settings.reference = reference;
            const ResponseResult result = calibration.run();
            QCOMPARE(result.unit, std::string("1"));
            QVERIFY(std::abs(result.magnitude[0] - std::abs(transferFunction(1e3))) < kAliasing);
            QVERIFY(result.sensitivity.has_value()); // stated beside the curve all the same
        }
    }
};

DYNCAL_TEST(TestSensorResponse)
#include "tst_sensor_response.moc"
