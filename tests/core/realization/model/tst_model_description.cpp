// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is pooled over the shots ("Several shots" and "FIT" of docs/method/model.md), against the
// formulas written out.

#include "core/realization/model/model_description.h"
#include "core/realization/refinement/draft_fit.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kF0_Hz = 40e3;
constexpr double kZeta = 0.06;
constexpr double kRounding = 1e-12;

const std::vector<double> kHeights{0.5, 2.0, -3.0};
const std::vector<double> kNoises{0.01, 0.01, 0.06};

ModelInput stepsOf(const std::vector<double> &heights, const std::vector<double> &noises)
{
    testing::Noise noise(12);
    std::vector<ModelSeries> list;
    for (std::size_t r = 0; r < heights.size(); ++r) {
        const Eigen::VectorXd y = heights[r] * testing::sampledStep(kF0_Hz, kZeta, kRate_Hz, 200)
            + noise.series(200, noises[r]);
        list.push_back(testing::makeSeries(
            static_cast<Index>(r) + 1, y, kRate_Hz, noise.series(500, noises[r])));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(list));
}

SensorModel described(const ModelInput &input)
{
    const Complex z = testing::secondOrderPole(kF0_Hz, kZeta, kRate_Hz);
    SensorModel model;
    describeModel(input, linearDraft(input, {z, std::conj(z)}), std::nullopt, model);
    return model;
}

} // namespace

class TestModelDescription : public QObject
{
    Q_OBJECT

private slots:
    void plateauAndShape_areMeansByClarity()
    {
        const ModelInput input = stepsOf(kHeights, kNoises);
        const SensorModel model = described(input);
        double weights = 0.0;
        double plateau = 0.0;
        Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(2);
        for (std::size_t r = 0; r < 3; ++r) {
            const SeriesFit &fit = model.series[r];
            const double weight = std::pow(fit.plateauGain / input.series[r].noiseSd, 2);
            weights += weight;
            plateau += weight * fit.plateauGain;
            shape += weight / fit.plateauGain * fit.amplitudes;
        }
        plateau /= weights;
        QVERIFY(std::abs(model.plateauGain / plateau - 1.0) < kRounding);
        QVERIFY((model.amplitudes - plateau / weights * shape).norm() < kRounding);
        QCOMPARE(model.amplitudes[1], std::conj(model.amplitudes[0]));
        for (std::size_t i = 0; i < 2; ++i)
            QCOMPARE(model.poles[i].amplitude, std::abs(model.amplitudes[static_cast<Index>(i)]));
    }

    void shotsOfOppositeDirection_shareTheirShape()
    {
        // A sensor that reads backwards in one shot has the same amplitudes relative to its step.
        const SensorModel one = described(stepsOf({1.0, 2.0}, {1e-9, 1e-9}));
        const SensorModel turned = described(stepsOf({1.0, -2.0}, {1e-9, 1e-9}));
        const Eigen::VectorXcd a = one.amplitudes / one.plateauGain;
        const Eigen::VectorXcd b = turned.amplitudes / turned.plateauGain;
        QVERIFY((a - b).norm() < 1e-7);
        // y = y' = 0 at the onset: c = s*/(s - s*) of the plateau.
        const Complex s = one.poles[0].s_rad_s;
        QVERIFY(std::abs(a[0] - std::conj(s) / (s - std::conj(s))) < 1e-6);
    }

    void withoutNoise_everyShotCountsAlike()
    {
        const SensorModel model = described(stepsOf({1.0, 2.0, 6.0}, {0.0, 0.0, 0.0}));
        QVERIFY(std::abs(model.plateauGain - 3.0) < 1e-9);
        QVERIFY(model.fit_percent > 100.0 - 1e-6);
        QCOMPARE(model.fitAttainable_percent, 100.0); // a quiet stretch without any noise
    }

    void fit_isPooledFromSums_notFromPercents()
    {
        const ModelInput input = stepsOf(kHeights, kNoises);
        const SensorModel model = described(input);
        double error = 0.0;
        double noise = 0.0;
        double spread = 0.0;
        for (std::size_t r = 0; r < 3; ++r) {
            const Eigen::VectorXd &y = input.series[r].y;
            const double own = (y.array() - y.mean()).square().sum();
            const double left = (y - model.series[r].simulated).squaredNorm();
            QVERIFY((model.series[r].error - (y - model.series[r].simulated)).norm() < kRounding);
            QVERIFY(std::abs(model.series[r].fit_percent - 100.0 * (1.0 - std::sqrt(left / own)))
                < 1e-10);
            error += left;
            noise += std::pow(input.series[r].noiseSd, 2) * 200.0;
            spread += own;
        }
        QVERIFY(std::abs(model.fit_percent - 100.0 * (1.0 - std::sqrt(error / spread))) < 1e-10);
        QVERIFY(std::abs(model.fitAttainable_percent - 100.0 * (1.0 - std::sqrt(noise / spread)))
            < 1e-10);
        // The true poles: what is left is the noise, known from 200 values to 5 %.
        const double ratio = (100.0 - model.fit_percent) / (100.0 - model.fitAttainable_percent);
        QVERIFY2(std::abs(ratio - 1.0) < 0.15, qPrintable(QString::number(ratio)));
    }

    void oneShotOfUnknownNoise_leavesTheAttainableUnknown()
    {
        ModelInput input = stepsOf(kHeights, kNoises);
        input.series[1].noise.resize(0);
        const SensorModel model = described(input);
        QVERIFY(std::isnan(model.fitAttainable_percent));
        QVERIFY(std::isnan(model.series[1].fitAttainable_percent));
        QVERIFY(std::isfinite(model.series[0].fitAttainable_percent));
        QVERIFY(std::isfinite(model.fit_percent));
    }

    void stretchLeftOut_countsForNothing()
    {
        ModelInput input = stepsOf(kHeights, kNoises);
        const SensorModel whole = described(input);
        // Nonsense in a stretch that is left out: the FIT does not see it, the error shows it.
        ModelSeries &series = input.series[0];
        series.leftOut = {{{50, 60}, series.fullRate.segment(50, 10)}};
        series.y.segment(50, 10).setConstant(1e3);
        series.correction = Eigen::VectorXd::Zero(200);
        series.correction.segment(50, 10)
            = whole.series[0].simulated.segment(50, 10) - series.y.segment(50, 10);
        const SensorModel model = described(input);
        QVERIFY(std::abs(model.series[0].fit_percent - whole.series[0].fit_percent) < 0.5);
        QVERIFY(model.series[0].error.segment(50, 10).minCoeff() > 900.0);
        QCOMPARE(model.series[0].leftOut.size(), std::size_t(1));
    }

    void uncertainties_areNoneWithoutARefinement()
    {
        const ModelInput input = stepsOf(kHeights, kNoises);
        SensorModel model = described(input);
        addUncertainties({}, model.poles);
        for (const Pole &pole : model.poles)
            QVERIFY(std::isnan(pole.u_frequency_Hz) && std::isnan(pole.coverageFactor));
        for (const SeriesFit &fit : model.series)
            QVERIFY(std::isnan(fit.u_plateauGain) && std::isnan(fit.u_onset_s));
    }
};

DYNCAL_TEST(TestModelDescription)
#include "tst_model_description.moc"
