// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Stretches left out of the fit: a burst that nobody can explain, put into one simulated shot.

#include "core/pipeline/pipeline.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 318e3;
constexpr double kZeta = 0.02;
constexpr double kBurstBegin_s = 20e-6; ///< behind the step, while the sensor rings
constexpr double kBurstEnd_s = 45e-6;

/// `burst`: three swings of 30 % of the step in shot 2.
SimulatedCapture simulated(bool burst, std::uint64_t seed)
{
    SimulationSettings settings;
    settings.sensor = {"piezo", 5e-6, {{kF0_Hz, kZeta, 1.0}}, {}, {}};
    settings.sampleRate_Hz = 10e6;
    settings.duration_s = 0.006;
    settings.noise = 0.01;
    settings.seed = seed;
    SimulatedCapture capture = simulateShots(settings).value();
    if (!burst)
        return capture;
    Channel &dut = capture.set.shots[1].channels[0];
    const ShotTruth &truth = capture.truth[1];
    const Eigen::VectorXd volts = physicalValues(dut, 0, dut.samples.size());
    std::vector<double> values(volts.begin(), volts.end());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double t_s = dut.timeOf_s(static_cast<Index>(i)) - truth.at("arrival_s");
        if (t_s > kBurstBegin_s && t_s < kBurstEnd_s)
            values[i] += 0.3 * truth.at("sensitivity") * truth.at("step_Pa")
                * std::sin(6.0 * M_PI * (t_s - kBurstBegin_s) / (kBurstEnd_s - kBurstBegin_s));
    }
    dut.adcMin.reset();
    dut.adcMax.reset();
    dut.polynomial = {0.0, 1.0};
    dut.samples = RawSamples(std::move(values));
    dut.sha256 = "burst";
    return capture;
}

ExcludedStretch burstStretch()
{
    // The detected start is at most a microsecond behind the step.
    return {2, kBurstBegin_s - 2e-6, kBurstEnd_s + 1e-6, "somebody knocked"};
}

Recipe recipeWith(std::vector<ExcludedStretch> stretches)
{
    Recipe recipe;
    recipe.window.excludeStretches = std::move(stretches);
    return recipe;
}

PipelineOutcome run(const SimulatedCapture &capture, const Recipe &recipe)
{
    ResultCache cache;
    return runPipeline(
        std::make_shared<const CaptureSet>(capture.set), recipe, cache, StageId::Assessment);
}

const Pole *mainPoleOf(const CalibrationResults &results)
{
    return mainPole(*results.model, results.assessment.get());
}

double deviation(const CalibrationResults &results)
{
    const Pole *pole = mainPoleOf(results);
    return std::abs(pole->frequency_Hz - kF0_Hz) / pole->u_frequency_Hz;
}

bool has(const Findings &findings, const std::string &id)
{
    return std::any_of(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
}

} // namespace

class TestLeftOut : public QObject
{
    Q_OBJECT

private slots:
    void burstLeftOut_sensorComesBack()
    {
        double squares = 0.0;
        constexpr int kSeeds = 4;
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
            const PipelineOutcome clean = run(simulated(false, seed), {});
            const PipelineOutcome out = run(simulated(true, seed), recipeWith({burstStretch()}));
            QVERIFY(clean.results.model && out.results.model && out.results.model->refined);
            QCOMPARE(out.results.model->order, Index(2));
            const Pole *pole = mainPoleOf(out.results);
            const Pole *reference = mainPoleOf(clean.results);
            squares += std::pow((pole->frequency_Hz - kF0_Hz) / pole->u_frequency_Hz, 2)
                + std::pow((pole->dampingRatio - kZeta) / pole->u_dampingRatio, 2);
            // The same noise elsewhere: the two differ by what the stretch told, no more.
            QVERIFY(std::abs(pole->frequency_Hz - reference->frequency_Hz)
                < 3.0 * pole->u_frequency_Hz);
            QVERIFY(pole->u_frequency_Hz > reference->u_frequency_Hz);
            QVERIFY(pole->u_frequency_Hz < 1.5 * reference->u_frequency_Hz);
            // Nothing of the burst is in the fit or in the response without a model.
            QVERIFY(out.results.model->fit_percent > clean.results.model->fit_percent - 1.5);
            QVERIFY(!has(out.results.response->findings, "RSP-001"));
        }
        qInfo("mean square of error over u: %.2f", squares / (2 * kSeeds));
        QVERIFY(squares / (2 * kSeeds) < 3.3); // 99.9 % point of chi square with 8 degrees
    }

    void burstLeftIn_spoilsTheModel()
    {
        const PipelineOutcome in = run(simulated(true, 1), {});
        const PipelineOutcome out = run(simulated(true, 1), recipeWith({burstStretch()}));
        QVERIFY(in.results.model && out.results.model);
        const bool wrong = !mainPoleOf(in.results) || in.results.model->order != 2
            || deviation(in.results) > 3.0
            || in.results.model->fit_percent < out.results.model->fit_percent - 5.0;
        QVERIFY(wrong);
    }

    void stretch_isListedWithItsReason()
    {
        const PipelineOutcome out = run(simulated(true, 1), recipeWith({burstStretch()}));
        QVERIFY(out.results.input);
        QCOMPARE(out.results.input->leftOut.size(), std::size_t(1));
        QCOMPARE(out.results.input->leftOut[0].reason, std::string("somebody knocked"));
        QVERIFY(has(out.results.input->findings, "WIN-007"));
    }

    void stretchesThatTouch_areOne()
    {
        const PipelineOutcome split
            = run(simulated(true, 1), recipeWith({{2, 30e-6, 46e-6, "b"}, {2, 18e-6, 31e-6, "a"}}));
        QVERIFY(split.results.input);
        const ModelSeries &series = split.results.input->series[1];
        QCOMPARE(series.leftOut.size(), std::size_t(1));
        // To the sample outside where a limit lies between two.
        const SampleRange samples = series.leftOut[0].samples;
        QVERIFY(samples.begin == 179 || samples.begin == 180);
        QVERIFY(samples.end == 461 || samples.end == 462);
        QCOMPARE(series.leftOut[0].recorded.size(), samples.size());
        QVERIFY(split.results.input->series[0].leftOut.empty());
    }

    void stretchOfAnUnusedShot_isIgnored()
    {
        Recipe recipe = recipeWith({{3, 10e-6, 20e-6, "x"}});
        recipe.import.exclude = {{3, "leak"}};
        const PipelineOutcome out = run(simulated(false, 1), recipe);
        QVERIFY(!out.error);
        QVERIFY(out.results.input->leftOut.empty());
    }

    void tooMuch_isRefused()
    {
        const PipelineOutcome out = run(simulated(false, 1), recipeWith({{1, 0.0, 1e-3, "x"}}));
        QVERIFY(out.error.has_value());
        QCOMPARE(out.error->findingId, std::string("WIN-008"));
        QCOMPARE(out.error->shot, Index(1));
    }

    void stretchOutsideTheWindow_isRefused()
    {
        for (const ExcludedStretch &stretch :
            {ExcludedStretch{1, 1.0, 2.0, "x"}, {1, 2e-5, 1e-5, "x"}, {1, -2.0, -1.0, "x"}}) {
            const PipelineOutcome out = run(simulated(false, 1), recipeWith({stretch}));
            QVERIFY(out.error.has_value());
            QVERIFY(out.error->kind == ErrorKind::Usage);
        }
    }

    void average_saysThatItKnowsNoStretches()
    {
        Recipe recipe = recipeWith({burstStretch()});
        recipe.input.combine = CombineMethod::PcaAverage;
        const PipelineOutcome out = run(simulated(true, 1), recipe);
        QVERIFY(out.results.input);
        QVERIFY(has(out.results.input->findings, "WIN-009"));
        QVERIFY(out.results.input->leftOut.empty());
    }
};

DYNCAL_TEST(TestLeftOut)
#include "tst_left_out.moc"
