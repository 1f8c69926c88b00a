// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the table of docs/accuracy.md: accuracy_table [SEEDS [FIRST_SEED [PRESET [RESULTS]]]]
// Every preset of the simulator (PRESET: that one, "all": all) as `dyncal simulate --preset P
// --noise 0.01 --seed N` makes it, the default recipe, seeds 1..SEEDS: error of f0 and zeta
// (optic1: of the -3 dB frequency) over what the noise allows. RESULTS: folder of the results of a
// `dyncal batch` whose sensors P_N are these recordings; nothing is calibrated here then.

#include "core/pipeline/pipeline.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/accuracy/noise_bound.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string>

using namespace dyncal;

namespace {

constexpr double kNoise = 0.01;

/// Errors of one quantity over the seeds, in units of the bound.
struct Column
{
    double squares = 0.0;
    double largest = 0.0;
    int beyond3 = 0;
    double relativeSquares = 0.0;
    double bound = 0.0;
    int count = 0;

    void add(double value, double truth, double standardDeviation)
    {
        const double z = (value - truth) / standardDeviation;
        squares += z * z;
        largest = std::max(largest, std::abs(z));
        beyond3 += std::abs(z) > 3.0;
        relativeSquares += (value / truth - 1.0) * (value / truth - 1.0);
        bound += standardDeviation / truth;
        ++count;
    }
};

struct Row
{
    std::map<std::string, Column> columns;
    std::map<Index, int> orders;
    double rate_Hz = 0.0;
    int failed = 0;
};

/// What a calibration says.
struct Found
{
    Index order = 0; ///< suggested
    double onset_s = 0.0; ///< of the first shot, relative to the detected start
    double f0_Hz = 0.0;
    double zeta = 0.0;
    double minus3dB_Hz = 0.0;
};

std::optional<Found> foundByPipeline(const CalibrationResults &r)
{
    const Pole *pole = r.model ? mainPole(*r.model, r.assessment.get()) : nullptr;
    if (!pole || !r.response)
        return std::nullopt;
    return Found{r.decomposition->suggestion.order, r.model->series.front().onset_s,
        pole->frequency_Hz, pole->dampingRatio,
        r.response->characteristics.minus3dB_Hz.value_or(0.0)};
}

std::optional<Found> foundInResults(const std::string &file)
{
    std::ifstream text(file);
    const nlohmann::json r = nlohmann::json::parse(text, nullptr, false);
    if (r.is_discarded() || !r["model"].is_object())
        return std::nullopt;
    std::map<std::string, double> values;
    for (const auto &one : r["characteristics"])
        if (one["value"].is_number())
            values[one["quantity"]] = one["value"];
    const auto &shot = r["shots"][0];
    return Found{r["realization"]["suggested_order"],
        shot["onset_s"].get<double>() - shot["start_s"].get<double>(), values["f0_hz"],
        values["damping_ratio"], values["minus_3_db_hz"]};
}

/// Of a pipeline that ended at the model's input, and what was found behind it.
void addErrors(const SensorSpec &sensor, const ModelInput &input, const Found &found, Row &row)
{
    row.rate_Hz = input.sampleRate_Hz;
    ++row.orders[found.order];
    const ModelSeries &series = input.series.front();
    const double first_s = series.first_s - found.onset_s;
    const auto bound = testing::noiseBound(
        sensor, 3, input.sampleRate_Hz, first_s, input.samples, kNoise * series.filter.taps.norm());
    const auto whole = testing::noiseBound(
        sensor, 3, series.fullRate_Hz, 1.0 / series.fullRate_Hz, series.fullRate.size(), kNoise);
    const SensorMode &truth = sensor.modes.front();
    if (sensor.name == "optic1") {
        const double trueLimit_Hz = testing::minus3dB_Hz(
            testing::exactRecords(sensor, 3, series.fullRate_Hz, series.fullRate.size()));
        row.columns["-3 dB, model input"].add(found.minus3dB_Hz, trueLimit_Hz, bound.minus3dB_Hz);
        row.columns["-3 dB, whole record"].add(found.minus3dB_Hz, trueLimit_Hz, whole.minus3dB_Hz);
        return;
    }
    row.columns["f0, model input"].add(found.f0_Hz, truth.f0_Hz, bound.f0_Hz);
    row.columns["f0, whole record"].add(found.f0_Hz, truth.f0_Hz, whole.f0_Hz);
    row.columns["zeta, model input"].add(found.zeta, truth.zeta, bound.zeta);
    row.columns["zeta, whole record"].add(found.zeta, truth.zeta, whole.zeta);
}

void addSeed(const SensorSpec &sensor, std::uint64_t seed, const std::string &results, Row &row)
{
    SimulationSettings settings;
    settings.sensor = sensor;
    settings.noise = kNoise;
    settings.seed = seed;
    const auto shots = simulateShots(settings);
    ResultCache cache;
    const PipelineOutcome outcome = runPipeline(std::make_shared<const CaptureSet>(shots->set), {},
        cache, results.empty() ? StageId::Assessment : StageId::ModelInput);
    const std::string name = sensor.name + '_' + std::to_string(seed);
    const std::optional<Found> found = results.empty()
        ? foundByPipeline(outcome.results)
        : foundInResults(results + '/' + name + "/calibration/results.json");
    if (outcome.error || !found) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(),
            outcome.error ? english(outcome.error->message).c_str() : "no resonance in the model");
        ++row.failed;
        return;
    }
    addErrors(sensor, *outcome.results.input, *found, row);
}

void print(const SensorSpec &sensor, const Row &row)
{
    std::string orders;
    for (const auto &[order, count] : row.orders)
        orders
            += (orders.empty() ? "" : ", ") + std::to_string(order) + ": " + std::to_string(count);
    for (const auto &[name, c] : row.columns) {
        std::printf("| %s | %.3g MHz | %s | %s | %.4f %% | %.4f %% | %.2f | %.2f | %d of %d |\n",
            sensor.name.c_str(), row.rate_Hz / 1e6, orders.c_str(), name.c_str(),
            100.0 * c.bound / c.count, 100.0 * std::sqrt(c.relativeSquares / c.count),
            std::sqrt(c.squares / c.count), c.largest, c.beyond3, c.count);
    }
    if (row.failed > 0)
        std::printf("| %s | failed | %d | | | | | | |\n", sensor.name.c_str(), row.failed);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 100;
    const int first = argc > 2 ? std::atoi(argv[2]) : 1;
    std::printf(
        "| preset | model rate | orders suggested | quantity, bound | bound | rms error | rms z | largest z | beyond 3 |\n|---|---|---|---|---|---|---|---|---|\n");
    const std::string only = argc > 3 ? argv[3] : "all";
    const std::string results = argc > 4 ? argv[4] : "";
    int failed = 0;
    for (const SensorSpec &sensor : sensorPresets()) {
        if (only != "all" && sensor.name != only)
            continue;
        Row row;
        for (int seed = first; seed < first + seeds; ++seed)
            addSeed(sensor, static_cast<std::uint64_t>(seed), results, row);
        print(sensor, row);
        failed += row.failed;
    }
    return failed > 0 ? 1 : 0;
}
