// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A front of known duration: what is left of the sensor's response behind it, and what is not.

#include "core/base/constants.h"
#include "core/realization/exponentials/front.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/input/input_preparation.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/second_order/second_order_fit.h"
#include "tests/support/model_inputs.h"
#include "tests/support/ramp_response.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 50e6;
constexpr double kF0_Hz = 400e3;
constexpr double kZeta = 0.3;
constexpr double kFront_s = 400e-9;

/// Middle of the front behind the detected start, which lies shortly after its begin.
double middle_s(Index shot)
{
    return 0.5 * kFront_s - 20e-9 + 3e-9 * double(shot);
}

WindowedResponse responseOf(Index shot, double noise, std::uint64_t seed)
{
    testing::Noise source(seed);
    WindowedResponse response;
    response.shot = shot;
    response.sampleRate_Hz = kRate_Hz;
    response.lead = 200;
    response.length = 3000;
    response.values = source.series(response.lead + response.length + 64, noise);
    for (Index k = 0; k < response.values.size(); ++k)
        response.values[k] += testing::rampResponse(
            kF0_Hz, kZeta, kFront_s, double(k - response.lead) / kRate_Hz - middle_s(shot));
    response.noise = source.series(5000, noise);
    response.noiseSd = noise;
    return response;
}

ModelInput inputOf(const std::vector<WindowedResponse> &responses, const FrontDuration &front)
{
    SpectrumResult spectrum;
    spectrum.resonances.push_back({kF0_Hz, 40.0, 1.7, {}});
    InputSettings settings;
    settings.sampleRate_Hz = kRate_Hz;
    settings.samples = 600;
    return prepareModelInput(responses, spectrum, {}, settings, front).value();
}

SensorModel modelOf(const ModelInput &input)
{
    const HankelDecomposition decomposition = decomposeHankel(input, RealizationSettings{}).value();
    return testing::realizeModel(input, decomposition, 2).value().model;
}

} // namespace

class TestFront : public QObject
{
    Q_OBJECT

private slots:
    void input_beginsBehindTheFront_withItsDoubt()
    {
        const std::vector<WindowedResponse> responses{responseOf(1, 0.0, 1)};
        const ModelInput sharp = inputOf(responses, {});
        QCOMPARE(sharp.offset_s, 0.0);
        QVERIFY(sharp.series[0].leftOut.empty());
        const ModelInput input = inputOf(responses, {kFront_s, 30e-9});
        QVERIFY(std::abs(input.offset_s - 460e-9) < 1e-12);
        QCOMPARE(input.series[0].leftOut.size(), std::size_t(1));
        QCOMPARE(input.series[0].leftOut[0].samples.end, Index(23));
        QVERIFY(input.leftOut.empty()); // nobody marked a stretch
        QCOMPARE(input.front.u_s, 30e-9);
        // A free decay has no front.
        SpectrumResult spectrum;
        InputSettings settings;
        settings.treatment = ResponseTreatment::Impulse;
        const ModelInput decay
            = prepareModelInput(responses, spectrum, {}, settings, {kFront_s, 0.0}).value();
        QCOMPARE(decay.front.duration_s, 0.0);
        QVERIFY(decay.series[0].leftOut.empty());
    }

    void sensor_isFoundBehindTheFront()
    {
        const std::vector<WindowedResponse> responses{responseOf(1, 0.0, 1), responseOf(2, 0.0, 2)};
        const SensorModel model = modelOf(inputOf(responses, {kFront_s, 0.0}));
        const Pole &pole = *mainPole(model.poles, model.series);
        QVERIFY(std::abs(pole.frequency_Hz / kF0_Hz - 1.0) < 1e-6);
        QVERIFY(std::abs(pole.dampingRatio / kZeta - 1.0) < 1e-6);
        for (const SeriesFit &fit : model.series) {
            QVERIFY(std::abs(fit.onset_s - middle_s(fit.shot)) < 1e-12);
            QVERIFY(std::abs(fit.plateauGain - 1.0) < 1e-8);
            // The amplitudes are those of a sharp step: level and ringing cancel at its onset.
            QVERIFY(std::abs(1.0 + fit.amplitudes.sum()) < 1e-6);
            QVERIFY(fit.leftOut.empty()); // nothing is filled in by the model
        }
        // Taken for a sharp step, the same records are not.
        const SensorModel wrong = modelOf(inputOf(responses, {}));
        QVERIFY(std::abs(mainPole(wrong.poles, wrong.series)->frequency_Hz / kF0_Hz - 1.0) > 1e-3);
    }

    void secondOrderBeside_knowsTheFront()
    {
        const std::vector<WindowedResponse> responses{
            responseOf(1, 1e-3, 3), responseOf(2, 1e-3, 4)};
        const auto fitted = [&](const FrontDuration &front) {
            const ModelInput input = inputOf(responses, front);
            return fitSecondOrder(input, refinementRecords(input),
                {{kF0_Hz * 1.02, kZeta, {1.0, 1.0}, {middle_s(1), middle_s(2)}}})
                ->sensor;
        };
        const SecondOrderModel known = fitted({kFront_s, 0.0});
        QVERIFY(std::abs(known.f0_Hz - kF0_Hz) < 4.0 * known.u_f0_Hz);
        QVERIFY(std::abs(known.zeta - kZeta) < 4.0 * known.u_zeta);
        const SecondOrderModel doubtful = fitted({kFront_s, 40e-9});
        QVERIFY(doubtful.u_zeta > 1.05 * known.u_zeta); // its gains are tied to the front's length
        const SecondOrderModel wrong = fitted({kFront_s + 120e-9, 40e-9});
        QVERIFY(std::abs(wrong.zeta - kZeta) < 4.0 * wrong.u_zeta);
    }

    void statedIntervals_holdTheTruth()
    {
        // 0.5 % noise, the duration wrong by its u: behind the front it does not matter.
        constexpr int kTrials = 60;
        int f0 = 0, zeta = 0;
        for (int trial = 0; trial < kTrials; ++trial) {
            const auto seed = static_cast<std::uint64_t>(2 * trial + 11);
            const std::vector<WindowedResponse> responses{
                responseOf(1, 5e-3, seed), responseOf(2, 5e-3, seed + 1)};
            const ModelInput input
                = inputOf(responses, {kFront_s + (trial % 2 ? 10e-9 : -10e-9), 10e-9});
            const HankelDecomposition decomposition
                = decomposeHankel(input, RealizationSettings{}).value();
            const auto realized = testing::realizeModel(input, decomposition, 2);
            QVERIFY(realized.has_value());
            const Pole &pole = *realized->main();
            f0 += std::abs(pole.frequency_Hz - kF0_Hz) <= pole.coverageFactor * pole.u_frequency_Hz;
            zeta
                += std::abs(pole.dampingRatio - kZeta) <= pole.coverageFactor * pole.u_dampingRatio;
        }
        qInfo("of %d: f0 %d, zeta %d within U", kTrials, f0, zeta);
        QVERIFY(f0 >= 52 && zeta >= 52); // of 57 expected, three standard deviations of 1.7
    }
};

DYNCAL_TEST(TestFront)
#include "tst_front.moc"
