// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A short version of docs/accuracy.md: every preset, a few seeds, against what the noise allows.

#include "core/pipeline/pipeline.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/accuracy/noise_bound.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kNoise = 0.01;
/// Of 27 normal values one lies beyond 4 standard deviations in 600 suites; the seeds are fixed, so
/// the suite either passes always or something changed.
constexpr double kLargest_z = 4.0;

CalibrationResults calibrate(const SensorSpec &sensor, std::uint64_t seed, const Recipe &recipe)
{
    SimulationSettings settings;
    settings.sensor = sensor;
    settings.noise = kNoise;
    settings.duration_s = 0.004;
    settings.seed = seed;
    const auto shots = simulateShots(settings);
    ResultCache cache;
    return runPipeline(
        std::make_shared<const CaptureSet>(shots->set), recipe, cache, StageId::Evidence)
        .results;
}

} // namespace

class TestAccuracy : public QObject
{
    Q_OBJECT

private slots:
    void presets_stayWithinWhatTheNoiseAllows_data()
    {
        QTest::addColumn<int>("preset");
        QTest::addColumn<int>("order");
        const int orders[] = {2, 2, 2, 2, 3};
        for (int i = 0; i < 5; ++i)
            QTest::newRow(sensorPresets()[static_cast<std::size_t>(i)].name.c_str())
                << i << orders[i];
    }
    void presets_stayWithinWhatTheNoiseAllows()
    {
        QFETCH(int, preset);
        QFETCH(int, order);
        const SensorSpec &sensor = sensorPresets()[static_cast<std::size_t>(preset)];
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const CalibrationResults r = calibrate(sensor, seed, {});
            QVERIFY(r.response);
            QCOMPARE(r.decomposition->suggestion.order, Index(order));
            const ModelSeries &series = r.input->series.front();
            const double first_s = series.first_s - r.model->series.front().onset_s;
            const auto bound = testing::noiseBound(sensor, 3, r.input->sampleRate_Hz, first_s,
                r.input->samples, kNoise * series.filter.taps.norm());
            QVERIFY(bound.f0_Hz > 0.0);
            if (sensor.name == "optic1") {
                const double truth_Hz = testing::minus3dB_Hz(
                    testing::exactRecords(sensor, 3, series.fullRate_Hz, series.fullRate.size()));
                const double z
                    = (*r.response->characteristics.minus3dB_Hz - truth_Hz) / bound.minus3dB_Hz;
                QVERIFY2(std::abs(z) < kLargest_z, qPrintable(QString::number(z)));
                continue;
            }
            const SensorMode &truth = sensor.modes.front();
            const Pole *pole = mainPole(*r.model, r.assessment.get());
            QVERIFY(pole);
            const double zf = (pole->frequency_Hz - truth.f0_Hz) / bound.f0_Hz;
            const double zz = (pole->dampingRatio - truth.zeta) / bound.zeta;
            QVERIFY2(std::abs(zf) < kLargest_z, qPrintable(QString::number(zf)));
            QVERIFY2(std::abs(zz) < kLargest_z, qPrintable(QString::number(zz)));
        }
    }

    void optic3_atTenMegahertz_seed7()
    {
        Recipe recipe;
        recipe.input.sampleRate_Hz = 10e6;
        const CalibrationResults r = calibrate(*sensorPreset("optic3"), 7, recipe);
        QVERIFY(r.response);
        QCOMPARE(r.decomposition->suggestion.order, Index(2));
        const Pole *pole = mainPole(*r.model, r.assessment.get());
        QVERIFY(std::abs(pole->frequency_Hz / 2.33e6 - 1.0) < 0.001);
        QVERIFY(std::abs(pole->dampingRatio / 0.02 - 1.0) < 0.03);
        QVERIFY(std::abs(*r.response->sensitivity / 5e-6 - 1.0) < 0.01);
    }

    void results_comeFromTheCacheWhereNothingChanged()
    {
        SimulationSettings settings;
        settings.sensor = *sensorPreset("optic3");
        settings.duration_s = 0.004;
        const auto captures = std::make_shared<const CaptureSet>(simulateShots(settings)->set);
        ResultCache cache;
        Recipe recipe;
        const auto first = runPipeline(captures, recipe, cache, StageId::Evidence).results;
        recipe.realization.order = Index(3);
        const auto second = runPipeline(captures, recipe, cache, StageId::Evidence).results;
        QCOMPARE(second.decomposition, first.decomposition); // the same object
        QVERIFY(second.model != first.model);
        recipe.realization.order = {};
        const auto third = runPipeline(captures, recipe, cache, StageId::Evidence).results;
        QCOMPARE(third.response, first.response);
        recipe.window.end_s = 0.0005;
        const auto fourth = runPipeline(captures, recipe, cache, StageId::Evidence).results;
        QCOMPARE(fourth.captures, first.captures);
        QVERIFY(fourth.window != first.window);
    }

    void run_stopsAtTheStageAsked_andOnRequest()
    {
        SimulationSettings settings;
        settings.sensor = *sensorPreset("optic3");
        settings.duration_s = 0.004;
        const auto captures = std::make_shared<const CaptureSet>(simulateShots(settings)->set);
        ResultCache cache;
        const auto some = runPipeline(captures, {}, cache, StageId::Spectrum);
        QVERIFY(!some.error && some.results.spectrum && !some.results.components);

        std::stop_source source;
        source.request_stop();
        ResultCache empty;
        const auto stopped
            = runPipeline(captures, {}, empty, StageId::Response, {source.get_token(), {}});
        QVERIFY(stopped.error && stopped.error->kind == ErrorKind::Cancelled);
        QVERIFY(!stopped.results.window);
    }

    void noDutChannel_isOneSentence()
    {
        SimulationSettings settings;
        settings.sensor = *sensorPreset("optic3");
        settings.duration_s = 0.004;
        CaptureSet set = simulateShots(settings)->set;
        for (Shot &shot : set.shots)
            shot.channels.front().role = ChannelRole::Other;
        ResultCache cache;
        const auto outcome
            = runPipeline(std::make_shared<const CaptureSet>(std::move(set)), {}, cache);
        QVERIFY(outcome.error.has_value());
        QCOMPARE(outcome.failedStage, StageId::Window);
        QVERIFY(!english(outcome.error->message).empty());
    }
};

DYNCAL_TEST(TestAccuracy)
#include "tst_accuracy.moc"
