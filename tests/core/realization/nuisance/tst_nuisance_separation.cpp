// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Sensor and modes told apart: what must not change the answer, and what must not spoil it.

#include "core/realization/input/left_out.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/nuisance/nuisance_separation.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Complex poleFrom(double frequency_Hz, double zeta)
{
    return kTwoPi * frequency_Hz * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
}

/// Two shots of a 30 kHz sensor with a vibration each, in units of value and time of one's choice.
struct Scene
{
    double value = 1.0;
    double time = 1.0;
    double noise = 1e-5;
    std::vector<double> frequency_Hz = {6.1e3, 6.8e3};

    double rate_Hz() const { return 1e6 / time; }
    NuisanceTerm term(Index shot) const
    {
        const double f_Hz = frequency_Hz[static_cast<std::size_t>(shot - 1)] / time;
        return {0, false, poleFrom(f_Hz, 0.015), value * std::polar(0.03, double(shot))};
    }
    Eigen::VectorXd sensor(Index count) const
    {
        return value * testing::sampledStep(3e4 / time, 0.05, rate_Hz(), count, 0.0);
    }
    WindowedResponse response(Index shot) const
    {
        testing::Noise source(static_cast<std::uint64_t>(shot) + 7);
        WindowedResponse one;
        one.shot = shot;
        one.sampleRate_Hz = rate_Hz();
        one.length = 1600;
        one.values = sensor(1600) + value * source.series(1600, noise);
        for (Index k = 0; k < 1600; ++k)
            one.values[k] += term(shot).value(static_cast<double>(k) / rate_Hz());
        one.noise = value * source.series(2000, noise);
        return one;
    }
    std::vector<NuisanceMode> modes() const
    {
        NuisanceMode mode{{}, 0, false, "vibration", "test"};
        for (const double f_Hz : frequency_Hz)
            mode.frequency_Hz.push_back(1.01 * f_Hz / time);
        return {mode};
    }
};

ModelInput inputOf(const std::vector<WindowedResponse> &responses)
{
    std::vector<ModelSeries> series;
    for (const WindowedResponse &response : responses)
        series.push_back(testing::makeSeries(
            response.shot, response.window().head(900), response.sampleRate_Hz, response.noise));
    ModelInput input = testing::makeInput(
        ResponseTreatment::StepDeflated, responses.front().sampleRate_Hz, std::move(series));
    input.combine = CombineMethod::Stacked;
    return input;
}

ModelInput separated(const Scene &scene, const std::vector<Index> &shots)
{
    std::vector<WindowedResponse> responses;
    for (const Index shot : shots)
        responses.push_back(scene.response(shot));
    ModelInput input = inputOf(responses);
    separateNuisance(input, responses, scene.modes(), {});
    return input;
}

} // namespace

class TestNuisanceSeparation : public QObject
{
    Q_OBJECT

private slots:
    void unitsOfValueAndTime_scaleTheTerms_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("time");
        QTest::newRow("as it is") << 1.0 << 1.0;
        QTest::newRow("small and fast") << 1e-9 << 1e-3;
        QTest::newRow("large, downwards, and slow") << -1e7 << 1e4;
    }
    void unitsOfValueAndTime_scaleTheTerms()
    {
        // No limit of the search may be one of volts or of seconds.
        QFETCH(double, value);
        QFETCH(double, time);
        const Scene scene{value, time};
        const ModelInput input = separated(scene, {1, 2});
        for (const ModelSeries &series : input.series) {
            QCOMPARE(series.nuisance.size(), std::size_t(1));
            const NuisanceTerm truth = scene.term(series.shot);
            const NuisanceTerm &found = series.nuisance[0];
            QVERIFY2(std::abs(found.pole_rad_s / truth.pole_rad_s - 1.0) < 1e-4,
                qPrintable(QString::number(found.frequency_Hz() * time, 'g', 9)));
            QVERIFY(std::abs(found.amplitude / truth.amplitude - 1.0) < 2e-3);
        }
        const Eigen::VectorXd rest = sensorOnly(input).series[1].y / value;
        QVERIFY((rest - scene.sensor(900) / value).cwiseAbs().maxCoeff() < 2e-4);
    }

    void orderOfTheShots_changesNothing()
    {
        const Scene scene;
        const ModelInput there = separated(scene, {1, 2});
        const ModelInput back = separated(scene, {2, 1});
        for (std::size_t r = 0; r < 2; ++r) {
            const NuisanceTerm &a = there.series[r].nuisance[0];
            const NuisanceTerm &b = back.series[1 - r].nuisance[0];
            QCOMPARE(there.series[r].shot, back.series[1 - r].shot);
            QVERIFY(std::abs(a.pole_rad_s / b.pole_rad_s - 1.0) < 1e-7);
            QVERIFY(std::abs(a.amplitude / b.amplitude - 1.0) < 1e-5);
        }
    }

    void sameInput_givesTheSameBits()
    {
        const ModelInput one = separated({}, {1, 2});
        const ModelInput other = separated({}, {1, 2});
        for (std::size_t r = 0; r < 2; ++r) {
            QVERIFY(one.series[r].nuisance[0].pole_rad_s == other.series[r].nuisance[0].pole_rad_s);
            QVERIFY(one.series[r].correction == other.series[r].correction);
        }
    }

    void burstLeftOut_spoilsNeitherModeNorSensor_data()
    {
        QTest::addColumn<bool>("withMode");
        QTest::addColumn<double>("from_s");
        QTest::newRow("in the ringing") << false << 40e-6;
        QTest::newRow("in the ringing, with a mode") << true << 40e-6;
        QTest::newRow("in the tail, with a mode") << true << 700e-6;
        QTest::newRow("behind the model input, with a mode") << true << 1200e-6;
    }
    void burstLeftOut_spoilsNeitherModeNorSensor()
    {
        // A burst of five times the step; the response bridged beneath it is the closed form.
        QFETCH(bool, withMode);
        QFETCH(double, from_s);
        const Scene scene;
        WindowedResponse response = scene.response(1);
        if (!withMode) {
            for (Index k = 0; k < 1600; ++k)
                response.values[k] -= scene.term(1).value(static_cast<double>(k) / 1e6);
        }
        const auto begin = static_cast<Index>(from_s * 1e6 + 0.5);
        response.values.segment(begin, 61).array() += 5.0;
        ModelInput input = inputOf({response});
        QVERIFY(leaveOut(input, {response}, {{1, from_s, from_s + 60e-6, "spark"}}).has_value());
        separateNuisance(
            input, {response}, withMode ? scene.modes() : std::vector<NuisanceMode>(), {});
        QCOMPARE(hasNuisance(input), withMode);
        const Eigen::VectorXd rest = sensorOnly(input).series[0].y;
        const double worst = (rest - scene.sensor(900)).cwiseAbs().maxCoeff();
        QVERIFY2(worst < 1e-3, qPrintable(QString::number(worst)));
        if (withMode)
            QVERIFY(
                std::abs(input.series[0].nuisance[0].pole_rad_s / scene.term(1).pole_rad_s - 1.0)
                < 1e-3);
    }

    void modeOnTheSensor_isStillSaidOrFitted()
    {
        // The mode's frequency is the sensor's own: the two cannot be told apart, but whatever is
        // taken out, nothing may run away.
        Scene scene;
        scene.frequency_Hz = {3e4, 3.05e4};
        const ModelInput input = separated(scene, {1, 2});
        for (const ModelSeries &series : sensorOnly(input).series) {
            QVERIFY(series.y.allFinite());
            QVERIFY(series.y.cwiseAbs().maxCoeff() < 4.0); // of a step to 1 that overshoots to 2
        }
    }

    void stopRequested_endsWithAWholeInput()
    {
        const Scene scene;
        const std::vector<WindowedResponse> responses{scene.response(1), scene.response(2)};
        ModelInput input = inputOf(responses);
        std::stop_source stop;
        stop.request_stop();
        separateNuisance(input, responses, scene.modes(), {}, {stop.get_token(), {}});
        for (const ModelSeries &series : input.series) {
            QVERIFY(series.correction.size() == 0 || series.correction.size() == series.y.size());
            QVERIFY(series.correction.allFinite());
        }
    }
};

DYNCAL_TEST(TestNuisanceSeparation)
#include "tst_nuisance_separation.moc"
