// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <cmath>
#include <numbers>

namespace dyncal::test {

/// A sensor of one resonance, put together by formula: pages can be driven without the pipeline.
inline constexpr double kRate_Hz = 20e6;
inline constexpr double kResonance_Hz = 1.5e6;
inline constexpr double kDamping = 0.03;
inline constexpr Index kSamples = 4000;

inline double stepResponse(double t_s)
{
    if (t_s < 0.0)
        return 0.0;
    const double w0 = 2.0 * std::numbers::pi * kResonance_Hz;
    const double wd = w0 * std::sqrt(1.0 - kDamping * kDamping);
    return 1.0
        - std::exp(-kDamping * w0 * t_s)
        * (std::cos(wd * t_s)
            + kDamping / std::sqrt(1.0 - kDamping * kDamping) * std::sin(wd * t_s));
}

/// Three shots with a DUT and a side channel each.
inline CaptureSet sampleCaptures()
{
    CaptureSet set;
    set.inputs = {{"/data/low.h5", "low.h5", std::string(64, 'a'), "test"}};
    const ShotLevel levels[] = {ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};
    for (int i = 0; i < 3; ++i) {
        Shot shot;
        shot.label = "shot " + std::to_string(i + 1);
        shot.level = levels[i];
        for (const auto &[name, role, delay] : {std::tuple("Sensor", ChannelRole::Dut, 0.0),
                 std::tuple("Side", ChannelRole::DrivenSide, -2e-5)}) {
            std::vector<std::int16_t> counts(8000);
            for (std::size_t k = 0; k < counts.size(); ++k) {
                const double t_s = (static_cast<double>(k) - 2000.0) / kRate_Hz - delay;
                counts[k] = static_cast<std::int16_t>(2000.0 * (i + 1) * stepResponse(t_s));
            }
            Channel channel;
            channel.name = name;
            channel.role = role;
            channel.samples = RawSamples(std::move(counts));
            channel.sampleRate_Hz = kRate_Hz;
            channel.t0_s = -1e-4;
            channel.polynomial = {0.0, 1e-3};
            shot.channels.push_back(channel);
        }
        set.shots.push_back(shot);
    }
    return set;
}

inline WindowedResponse sampleResponse(Index shot, const WindowSettings &settings)
{
    WindowedResponse r;
    r.shot = shot;
    r.level = static_cast<ShotLevel>(shot);
    r.unit = "V";
    r.sampleRate_Hz = kRate_Hz;
    r.baseline_s = settings.baseline_s.value.value_or(Interval{-5e-5, -5e-6});
    r.settle_s = settings.settle_s.value.value_or(Interval{8e-5, 1.4e-4});
    r.end_s = settings.endOfShot_s(shot).value.value_or(1.5e-4);
    r.step = 2.0 * static_cast<double>(shot);
    r.settled = r.step;
    r.valueScale = r.step;
    r.noiseSd = 0.01;
    r.snr_dB = 46.0;
    r.lead = 1000;
    r.length = std::min<Index>(std::lround(r.end_s * kRate_Hz), kSamples - 1000);
    r.values.resize(kSamples);
    for (Index k = 0; k < kSamples; ++k)
        r.values[k] = stepResponse(static_cast<double>(k - r.lead) / kRate_Hz);
    r.riseTime_s = 1.2e-7;
    r.overshoot_percent = 91.0;
    return r;
}

inline std::shared_ptr<const SensorModel> sampleModel(const Recipe &recipe, const ModelInput &input)
{
    auto model = std::make_shared<SensorModel>();
    model->order = recipe.realization.order.value.value_or(2);
    const double w0 = 2.0 * std::numbers::pi * kResonance_Hz;
    for (const double sign : {1.0, -1.0}) {
        Pole pole;
        pole.s_rad_s = {-kDamping * w0, sign * w0 * std::sqrt(1.0 - kDamping * kDamping)};
        pole.z = std::exp(pole.s_rad_s / input.sampleRate_Hz);
        pole.poleClass = PoleClass::Sensor;
        pole.frequency_Hz = kResonance_Hz;
        pole.dampingRatio = kDamping;
        pole.amplitude = 1.0;
        model->poles.push_back(pole);
    }
    for (const ModelSeries &series : input.series) {
        SeriesFit fit;
        fit.shot = series.shot;
        fit.plateauGain = 1.0;
        fit.simulated = series.y;
        fit.error = Eigen::VectorXd::Zero(series.y.size());
        fit.fit_percent = 89.4;
        fit.fitAttainable_percent = 89.9;
        model->series.push_back(fit);
    }
    model->fit_percent = 89.4;
    model->fitAttainable_percent = 89.9;
    return model;
}

inline std::shared_ptr<const ModelAssessment> sampleAssessment(const SensorModel &model)
{
    auto assessment = std::make_shared<ModelAssessment>();
    assessment->poles = model.poles;
    return assessment;
}

inline std::shared_ptr<const DecompositionResult> sampleDecomposition()
{
    auto result = std::make_shared<DecompositionResult>();
    result->hankel.singularValues.resize(40);
    for (Index i = 0; i < 40; ++i)
        result->hankel.singularValues[i]
            = i < 2 ? 100.0 - static_cast<double>(i) : 1.0 / (1.0 + 0.02 * static_cast<double>(i));
    result->hankel.rows = 499;
    result->hankel.noiseFloor_p95 = 1.1;
    result->suggestion.order = 2;
    result->suggestion.reason = {"The criterion is smallest at order %1.", {"2"}};
    result->suggestion.bic = Eigen::VectorXd::LinSpaced(20, 10.0, 60.0);
    return result;
}

inline std::shared_ptr<const ComponentResult> sampleComponents(const WindowResult &window)
{
    auto result = std::make_shared<ComponentResult>();
    const auto shots = static_cast<Index>(window.responses.size());
    const Index length = window.responses.front().length;
    result->sampleRate_Hz = kRate_Hz;
    result->responses.resize(length, shots);
    PrincipalComponents principal;
    principal.explainedCumulative_percent = Eigen::VectorXd::LinSpaced(shots, 99.8, 100.0);
    principal.singularValues = Eigen::VectorXd::LinSpaced(shots, 10.0, 0.1);
    result->principal = principal;
    for (Index i = 0; i < shots; ++i) {
        const WindowedResponse &response = window.responses[static_cast<std::size_t>(i)];
        result->shots.push_back(response.shot);
        result->responses.col(i) = response.window();
        ResidualAnalysis residual;
        residual.rms = 1e-3;
        residual.autocovariance = Eigen::VectorXd::LinSpaced(101, 1.0, 0.0);
        residual.confidenceBound = 0.05;
        residual.outsideFraction = 0.38;
        residual.whiteness_p = 1e-4;
        residual.spectrum.frequency_Hz = Eigen::VectorXd::LinSpaced(500, 1e4, 1e7);
        residual.spectrum.psd = residual.spectrum.frequency_Hz.array().inverse();
        residual.peaks_Hz = {6.8e3};
        result->residuals.push_back(residual);
    }
    result->reconstructions = result->responses;
    result->average = result->responses.rowwise().mean();
    return result;
}

inline std::shared_ptr<const ShockConditionsSet> sampleShock(const WindowResult &window)
{
    auto result = std::make_shared<ShockConditionsSet>();
    for (const WindowedResponse &response : window.responses) {
        ShockConditions shot;
        shot.shot = response.shot;
        shot.states
            = shockStates({}, 101100.0, 294.15, 440.0 + 24.0 * static_cast<double>(shot.shot))
                  .value_or(ShockStates{});
        shot.step_Pa = shot.states->reflected.pressure_Pa - shot.states->driven.pressure_Pa;
        shot.plateau_s = 1.63e-3;
        shot.arrival_s = -2e-5;
        shot.distance_m = 0.3;
        result->shots.push_back(shot);
    }
    Finding caution;
    caution.id = "SHK-003";
    caution.severity = Severity::Caution;
    caution.message = {"Velocity uncertainty %1 gives %2 on the pressure step (factor %3).",
        {"0.33 %", "1.5 %", "4.65"}};
    result->findings.push_back(caution);
    return result;
}

inline std::shared_ptr<const ResponseResult> sampleResponseResult(const ShockConditionsSet &shock)
{
    auto result = std::make_shared<ResponseResult>();
    const Index count = 600;
    auto &curve = result->modelCurve;
    curve.frequency_Hz.resize(count);
    curve.magnitude.resize(count);
    curve.phase_rad.resize(count);
    for (Index i = 0; i < count; ++i) {
        const double f_Hz = 1e3 * std::pow(1e4, static_cast<double>(i) / (count - 1));
        const double x = f_Hz / kResonance_Hz;
        const std::complex<double> g = 1.0 / std::complex<double>(1.0 - x * x, 2.0 * kDamping * x);
        curve.frequency_Hz[i] = f_Hz;
        curve.magnitude[i] = 5e-6 * std::abs(g);
        curve.phase_rad[i] = std::arg(g);
    }
    result->frequency_Hz = curve.frequency_Hz(Eigen::seq(0, count - 1, 30));
    result->magnitude = curve.magnitude(Eigen::seq(0, count - 1, 30));
    result->phase_rad = curve.phase_rad(Eigen::seq(0, count - 1, 30));
    result->modelMagnitude = result->magnitude;
    result->modelPhase_rad = result->phase_rad;
    result->u_magnitude = 0.02 * result->magnitude;
    result->u_phase_rad = Eigen::VectorXd::Constant(result->phase_rad.size(), 0.02);
    result->fLow_Hz = 6e3;
    result->fHigh_Hz = 3e6;
    result->unit = "V/Pa";
    result->characteristics.riseTime_s = 1.2e-7;
    result->characteristics.overshoot_percent = 91.0;
    result->characteristics.within5percent_Hz = 3.3e5;
    for (const ShockConditions &shot : shock.shots)
        result->shots.push_back({shot.shot, 5.02e-6, "V/Pa"});
    result->sensitivity = 5.02e-6;
    result->sensitivityUnit = "V/Pa";
    return result;
}

/// The rise time alone has a budget.
inline std::shared_ptr<const UncertaintyReport> sampleUncertainty()
{
    auto report = std::make_shared<UncertaintyReport>();
    ReportedValue rise{"rise_time_s", 120e-9, "s", {directLine("noise", 2.1e-9)}};
    combineLines(rise);
    report->ofModel = {rise};
    return report;
}

/// Stands in for runPipeline: formula results up to the response.
inline PipelineOutcome samplePipeline(const std::shared_ptr<const CaptureSet> &captures,
    const Recipe &recipe, ResultCache &, StageId, const JobControl &)
{
    CalibrationResults results;
    auto prepared = std::make_shared<PreparedCaptures>();
    prepared->set = *captures;
    for (const ExcludedShot &out : recipe.import.exclude)
        prepared->set.shots[static_cast<std::size_t>(out.shot - 1)].included = false;
    results.captures = prepared;

    auto window = std::make_shared<WindowResult>();
    auto spectrum = std::make_shared<SpectrumResult>();
    auto input = std::make_shared<ModelInput>();
    input->sampleRate_Hz = kRate_Hz;
    input->samples = 600;
    input->samplesPerPeriod = kRate_Hz / kResonance_Hz;
    const auto shots = std::min<Index>(3, static_cast<Index>(prepared->set.shots.size()));
    for (Index shot = 1; shot <= shots; ++shot) {
        if (!prepared->set.shots[static_cast<std::size_t>(shot - 1)].included)
            continue;
        const WindowedResponse response = sampleResponse(shot, recipe.window);
        window->responses.push_back(response);
        PowerSpectrum psd;
        psd.frequency_Hz = Eigen::VectorXd::LinSpaced(1000, 1e4, 1e7);
        psd.psd = (1.0 + (psd.frequency_Hz.array() / kResonance_Hz - 1.0).square() * 1e4).inverse();
        spectrum->perShot.push_back(psd);
        ModelSeries series;
        series.shot = shot;
        series.y = response.window().head(input->samples);
        series.fullRate = series.y;
        series.fullRate_Hz = kRate_Hz;
        input->series.push_back(series);
    }
    spectrum->resonances = {{kResonance_Hz, 30.0, 16.0, {kResonance_Hz, kResonance_Hz, {}}}};
    results.window = window;
    results.spectrum = spectrum;
    results.input = input;
    results.decomposition = sampleDecomposition();
    results.model = sampleModel(recipe, *input);
    results.assessment = sampleAssessment(*results.model);
    results.components = sampleComponents(*window);
    results.shock = sampleShock(*window);
    results.starts = std::make_shared<RecordStarts>();
    results.expected = std::make_shared<ExpectedShock>(ExpectedShock{*results.shock, {}});
    results.monteCarlo = std::make_shared<StepMonteCarloSet>();
    results.response = sampleResponseResult(*results.shock);
    results.checks = std::make_shared<ConsistencyResult>();
    results.uncertainty = sampleUncertainty();
    return {results, std::nullopt, StageId::Captures};
}

} // namespace dyncal::test
