// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Simulated shots with a 6.8 kHz mode of the gas: with the mode taken out, f0, zeta and plateau
// sensitivity come back to within their stated uncertainty. DYNCAL_SEEDS sets the number of seeds.

#include "core/pipeline/pipeline.h"
#include "core/synthesis/shot_generator.h"

#include <QTest>

#include <cmath>
#include <cstdio>

using namespace dyncal;

namespace {

struct Sensor
{
    const char *name;
    double f0_Hz;
    double zeta;
    double rate_Hz;
};

const std::vector<Sensor> kSensors{
    {"2.33 MHz", 2.33e6, 0.02, 100e6}, {"318 kHz", 318e3, 0.02, 20e6}, {"30 kHz", 30e3, 0.05, 2e6}};

SimulatedCapture simulated(const Sensor &sensor, std::uint64_t seed, bool withMode)
{
    SimulationSettings settings;
    settings.sensor = {sensor.name, 5e-6, {{sensor.f0_Hz, sensor.zeta, 1.0}}, {}, {}};
    settings.sampleRate_Hz = sensor.rate_Hz;
    settings.duration_s = 0.008;
    settings.noise = 0.01;
    settings.seed = seed;
    if (withMode)
        settings.defects = {{DefectKind::TubeMode, 0}};
    return simulateShots(settings).value();
}

Recipe recipeWithMode()
{
    Recipe recipe;
    NuisanceMode mode;
    mode.frequency_Hz = {6.8e3};
    mode.shot = 3;
    mode.label = "transverse";
    mode.reason = "moves with the sound speed";
    recipe.realization.nuisanceModes = {mode};
    return recipe;
}

CalibrationResults calibrated(const SimulatedCapture &capture, const Recipe &recipe)
{
    ResultCache cache;
    PipelineOutcome outcome
        = runPipeline(std::make_shared<const CaptureSet>(capture.set), recipe, cache);
    if (outcome.error)
        qWarning("%s", english(outcome.error->message).c_str());
    return outcome.results;
}

/// Mean of (error / stated uncertainty)^2.
struct Squares
{
    double sum = 0.0;
    int count = 0;
    double largest = 0.0;

    void add(double value, double truth, double u)
    {
        const double z = (value - truth) / u;
        sum += z * z;
        largest = std::max(largest, std::abs(z));
        ++count;
    }
    double mean() const { return sum / count; }
};

struct Score
{
    Squares f0;
    Squares zeta;
    Squares plateau; ///< of every shot
    Squares mode_Hz;
    Squares modeZeta;
    int failed = 0;
    int order2 = 0;
};

void add(const SimulatedCapture &capture, const CalibrationResults &results, Score &score)
{
    const Pole *pole = results.model ? mainPole(*results.model) : nullptr;
    if (!pole || !std::isfinite(pole->u_frequency_Hz)) {
        ++score.failed;
        return;
    }
    score.order2 += results.model->order == 2;
    score.f0.add(pole->frequency_Hz, capture.truth[0].at("f0_Hz"), pole->u_frequency_Hz);
    score.zeta.add(pole->dampingRatio, capture.truth[0].at("zeta"), pole->u_dampingRatio);
    for (std::size_t r = 0; r < results.model->series.size(); ++r) {
        const SeriesFit &fit = results.model->series[r];
        const ShotTruth &truth = capture.truth[static_cast<std::size_t>(fit.shot - 1)];
        const WindowedResponse &response = results.window->responses[r];
        score.plateau.add(fit.plateauGain * response.valueScale,
            truth.at("sensitivity") * truth.at("step_Pa"),
            fit.u_plateauGain * std::abs(response.valueScale));
    }
    for (const NuisanceResult &mode : results.model->nuisance) {
        for (const NuisanceOfShot &shot : mode.perShot) {
            const ShotTruth &truth = capture.truth[static_cast<std::size_t>(shot.shot - 1)];
            score.mode_Hz.add(
                shot.term.frequency_Hz(), truth.at("tube_mode_Hz"), shot.u_frequency_Hz);
            score.modeZeta.add(
                shot.term.dampingRatio(), truth.at("tube_mode_zeta"), shot.u_dampingRatio);
        }
    }
}

void print(const char *name, const char *what, const Score &score)
{
    std::printf("%-10s %-12s f0 %.2f (%.1f)  zeta %.2f (%.1f)  plateau %.2f (%.1f)  mode f %.2f "
                "zeta %.2f n %d  order 2: %d, failed %d\n",
        name, what, score.f0.mean(), score.f0.largest, score.zeta.mean(), score.zeta.largest,
        score.plateau.mean(), score.plateau.largest, score.mode_Hz.mean(), score.modeZeta.mean(),
        score.mode_Hz.count, score.order2, score.failed);
    std::fflush(stdout);
}

} // namespace

class TestTubeModes : public QObject
{
    Q_OBJECT

private slots:
    void sensorComesBack_withinItsStatedUncertainty()
    {
        const int seeds = qEnvironmentVariableIntValue("DYNCAL_SEEDS") > 0
            ? qEnvironmentVariableIntValue("DYNCAL_SEEDS")
            : 6;
        for (const Sensor &sensor : kSensors) {
            Score none;
            Score leftIn;
            Score takenOut;
            for (int seed = 1; seed <= seeds; ++seed) {
                const auto number = static_cast<std::uint64_t>(seed);
                const SimulatedCapture clean = simulated(sensor, number, false);
                add(clean, calibrated(clean, {}), none);
                const SimulatedCapture capture = simulated(sensor, number, true);
                add(capture, calibrated(capture, {}), leftIn);
                add(capture, calibrated(capture, recipeWithMode()), takenOut);
            }
            print(sensor.name, "no mode", none);
            print(sensor.name, "left in", leftIn);
            print(sensor.name, "taken out", takenOut);
        }
    }
};

QTEST_APPLESS_MAIN(TestTubeModes)
#include "tst_tube_modes.moc"
