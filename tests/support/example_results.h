// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <cmath>
#include <complex>
#include <random>

namespace dyncal::example {

// A sensor of second order, 2.33 MHz, zeta 0.02, hit by three shots: results written down from the
// closed forms, without running the analysis.
inline constexpr double kF0_Hz = 2.33e6;
inline constexpr double kZeta = 0.02;
inline constexpr double kSensitivity_V_Pa = 12.5e-6;
inline constexpr double kNoise = 0.002; ///< of the step
inline constexpr double kModelRate_Hz = 10e6;

struct Size
{
    double rate_Hz = 50e6;
    double window_s = 100e-6;
    Index modelSamples = 400;
    Index frequencies = 12;
};

inline std::complex<double> pole_rad_s()
{
    const double w0 = 2.0 * M_PI * kF0_Hz;
    return {-kZeta * w0, w0 * std::sqrt(1.0 - kZeta * kZeta)};
}

inline std::complex<double> amplitude()
{
    return -0.5 * std::complex<double>(1.0, -kZeta / std::sqrt(1.0 - kZeta * kZeta));
}

/// Unit step response of the sensor.
inline double stepResponse(double t_s)
{
    return t_s < 0.0 ? 0.0 : 1.0 + 2.0 * (amplitude() * std::exp(pole_rad_s() * t_s)).real();
}

/// G(jw) = c0 + sum c_i jw/(jw - s_i).
inline std::complex<double> response(double frequency_Hz)
{
    const std::complex<double> jw(0.0, 2.0 * M_PI * frequency_Hz);
    const std::complex<double> s = pole_rad_s();
    const std::complex<double> c = amplitude();
    return 1.0 + c * jw / (jw - s) + std::conj(c) * jw / (jw - std::conj(s));
}

inline ShotLevel levelOf(Index shot)
{
    return shot == 1 ? ShotLevel::Low : shot == 2 ? ShotLevel::Medium : ShotLevel::High;
}

inline double stepOf_Pa(Index shot)
{
    return shot == 1 ? 169e3 : shot == 2 ? 280.2e3 : 434.5e3;
}

inline Eigen::VectorXd ringing(
    Index count, double first_s, double rate_Hz, std::mt19937 &random, double noise)
{
    std::normal_distribution<double> normal(0.0, noise);
    Eigen::VectorXd values(count);
    for (Index i = 0; i < count; ++i)
        values[i] = stepResponse(first_s + static_cast<double>(i) / rate_Hz)
            + (noise > 0.0 ? normal(random) : 0.0);
    return values;
}

inline std::shared_ptr<const PreparedCaptures> captures(const Size &size)
{
    auto prepared = std::make_shared<PreparedCaptures>();
    CaptureSet &set = prepared->set;
    set.inputs.push_back({"/data/optic3.h5", "optic3.h5",
        "9f3a5b7c1d2e4f60718293a4b5c6d7e8f90123456789abcdef0123456789abcd", "dyncal-capture"});
    set.sensors["optic3"]
        = {{"manufacturer", "Fibre Works"}, {"model", "optic3"}, {"serial", "SN-0042"}};
    for (Index shot = 1; shot <= 3; ++shot) {
        Channel dut;
        dut.name = "ch0";
        dut.role = ChannelRole::Dut;
        dut.sensorId = "optic3";
        dut.sampleRate_Hz = size.rate_Hz;
        dut.t0_s = -0.2 * size.window_s;
        dut.polynomial = {0.0, 1e-3};
        std::vector<std::int16_t> counts;
        const double step_V = kSensitivity_V_Pa * stepOf_Pa(shot);
        for (Index i = 0; i < static_cast<Index>(1.3 * size.window_s * size.rate_Hz); ++i)
            counts.push_back(
                static_cast<std::int16_t>(1e3 * step_V * stepResponse(dut.timeOf_s(i))));
        dut.samples = RawSamples(std::move(counts));
        Shot entry;
        entry.label = "shot " + std::to_string(shot);
        entry.level = levelOf(shot);
        entry.channels.push_back(std::move(dut));
        entry.environment.ambientT_K = 294.15;
        set.shots.push_back(std::move(entry));
    }
    return prepared;
}

inline std::shared_ptr<const WindowResult> window(const Size &size)
{
    auto result = std::make_shared<WindowResult>();
    std::mt19937 random(1);
    for (Index shot = 1; shot <= 3; ++shot) {
        WindowedResponse response;
        response.shot = shot;
        response.level = levelOf(shot);
        response.unit = "V";
        response.sampleRate_Hz = size.rate_Hz;
        response.lead = static_cast<Index>(0.2 * size.window_s * size.rate_Hz);
        response.length = static_cast<Index>(size.window_s * size.rate_Hz);
        response.startSample = response.lead;
        response.step = kSensitivity_V_Pa * stepOf_Pa(shot);
        response.settled = response.step;
        response.valueScale = response.step;
        response.noiseSd = kNoise * response.step;
        response.snr_dB = 20.0 * std::log10(1.0 / kNoise);
        response.riseTime_s = 7.2e-8;
        response.overshoot_percent = 93.9;
        response.settlingTime_s = 1.0e-5;
        response.end_s = size.window_s;
        response.values = ringing(response.lead + response.length,
            -static_cast<double>(response.lead) / size.rate_Hz, size.rate_Hz, random, kNoise);
        result->responses.push_back(std::move(response));
    }
    return result;
}

inline PowerSpectrum spectrumOf(const Size &size, std::mt19937 &random, double floor)
{
    std::exponential_distribution<double> chi(1.0);
    const auto bins = static_cast<Index>(0.5 * size.window_s * size.rate_Hz);
    PowerSpectrum spectrum;
    spectrum.frequency_Hz = Eigen::VectorXd::LinSpaced(
        bins, 1.0 / size.window_s, static_cast<double>(bins) / size.window_s);
    spectrum.psd.resize(bins);
    for (Index i = 0; i < bins; ++i) {
        const double f = spectrum.frequency_Hz[i];
        spectrum.psd[i]
            = floor * chi(random) + 1e-2 * std::norm(response(f)) / (f * f) / size.window_s;
    }
    return spectrum;
}

inline std::shared_ptr<const SpectrumResult> spectrum(const Size &size)
{
    auto result = std::make_shared<SpectrumResult>();
    std::mt19937 random(2);
    for (int shot = 0; shot < 3; ++shot)
        result->perShot.push_back(spectrumOf(size, random, 1e-13));
    result->resonances.push_back({kF0_Hz, 31.0, 24.0, {kF0_Hz, kF0_Hz, kF0_Hz}});
    return result;
}

inline std::shared_ptr<const ComponentResult> components(const Size &size)
{
    auto result = std::make_shared<ComponentResult>();
    std::mt19937 random(3);
    const WindowResult responses = *window(size);
    const Index count = responses.responses.front().length;
    result->shots = {1, 2, 3};
    result->sampleRate_Hz = size.rate_Hz;
    result->responses.resize(count, 3);
    result->reconstructions.resize(count, 3);
    const Eigen::VectorXd clean = ringing(count, 0.0, size.rate_Hz, random, 0.0);
    for (Index i = 0; i < 3; ++i) {
        result->responses.col(i) = responses.responses[static_cast<std::size_t>(i)].window();
        result->reconstructions.col(i) = clean;
        ResidualAnalysis residual;
        residual.rms = kNoise;
        residual.autocovariance = Eigen::VectorXd::Zero(101);
        residual.autocovariance[0] = 1.0;
        residual.confidenceBound = 2.576 / std::sqrt(static_cast<double>(count));
        residual.spectrum = spectrumOf(size, random, 1e-13);
        residual.peaks_Hz = {6.8e3};
        result->residuals.push_back(std::move(residual));
    }
    result->average = clean;
    PrincipalComponents principal;
    principal.explainedCumulative_percent = Eigen::Vector3d(99.886, 99.95, 100.0);
    principal.singularValues = Eigen::Vector3d(120.0, 3.0, 2.7);
    result->principal = principal;
    return result;
}

inline std::shared_ptr<const ModelInput> modelInput(const Size &size)
{
    auto input = std::make_shared<ModelInput>();
    std::mt19937 random(4);
    input->sampleRate_Hz = kModelRate_Hz;
    input->offset_s = 1.5e-6;
    input->samples = size.modelSamples;
    for (Index shot = 1; shot <= 3; ++shot) {
        ModelSeries series;
        series.shot = shot;
        series.first_s = input->offset_s;
        series.y = ringing(size.modelSamples, series.first_s, kModelRate_Hz, random, kNoise);
        series.noiseSd = kNoise;
        series.fullRate_Hz = size.rate_Hz;
        const double until_s
            = series.first_s + static_cast<double>(size.modelSamples) / kModelRate_Hz;
        series.fullRate = ringing(
            static_cast<Index>(until_s * size.rate_Hz), 0.0, size.rate_Hz, random, kNoise);
        input->series.push_back(std::move(series));
    }
    input->samplesPerPeriod = kModelRate_Hz / kF0_Hz;
    input->lostResponse_percent = 36.0;
    return input;
}

inline std::shared_ptr<const DecompositionResult> decomposition()
{
    auto result = std::make_shared<DecompositionResult>();
    result->hankel.rows = 199;
    result->hankel.columns = 600;
    result->hankel.onesProjected = true;
    result->hankel.method = "dense";
    result->hankel.singularValues.resize(40);
    for (Index i = 0; i < 40; ++i)
        result->hankel.singularValues[i] = i < 2 ? 900.0 - 60.0 * static_cast<double>(i)
                                                 : 52.0 * std::exp(-0.01 * static_cast<double>(i));
    result->hankel.noiseFloor_p95 = 55.0;
    result->suggestion.order = 2;
    result->suggestion.reason
        = {"Order %1 has the smallest BIC of the orders 1 to %2.", {"2", "20"}};
    result->suggestion.bic = Eigen::VectorXd::LinSpaced(20, -1000.0, -800.0);
    result->suggestion.bic[1] = -5200.0;
    return result;
}

inline std::shared_ptr<const SensorModel> model(const ModelInput &input)
{
    auto result = std::make_shared<SensorModel>();
    result->order = 2;
    for (const bool upper : {true, false}) {
        Pole pole;
        pole.s_rad_s = upper ? pole_rad_s() : std::conj(pole_rad_s());
        pole.z = std::exp(pole.s_rad_s / kModelRate_Hz);
        pole.poleClass = PoleClass::Sensor;
        pole.frequency_Hz = kF0_Hz;
        pole.dampingRatio = kZeta;
        pole.amplitude = std::abs(amplitude());
        result->poles.push_back(pole);
    }
    result->zeros = {{-0.98, 0.0}, {3.7, 0.0}};
    result->plateauGain = 1.0;
    result->amplitudes = Eigen::Vector2cd(amplitude(), std::conj(amplitude()));
    result->fit_percent = 98.76;
    result->fitAttainable_percent = 98.91;
    std::mt19937 random(5);
    for (const ModelSeries &series : input.series) {
        SeriesFit fit;
        fit.shot = series.shot;
        fit.plateauGain = 1.0;
        fit.amplitudes = result->amplitudes;
        fit.simulated = ringing(series.y.size(), series.first_s, input.sampleRate_Hz, random, 0.0);
        fit.error = series.y - fit.simulated;
        fit.fit_percent = 98.76;
        result->series.push_back(std::move(fit));
    }
    return result;
}

inline std::shared_ptr<const ModelAssessment> assessment(const SensorModel &fitted)
{
    auto result = std::make_shared<ModelAssessment>();
    result->poles = fitted.poles;
    for (Pole &pole : result->poles) {
        pole.u_frequency_Hz = 412.0;
        pole.u_dampingRatio = 0.000177;
    }
    return result;
}

inline std::shared_ptr<const ShockConditionsSet> shock()
{
    auto result = std::make_shared<ShockConditionsSet>();
    for (Index shot = 1; shot <= 3; ++shot) {
        ShockConditions conditions;
        conditions.shot = shot;
        ShockStates states;
        states.velocity_m_s = 400.0 + 37.6 * static_cast<double>(shot);
        states.mach = states.velocity_m_s / 344.0577;
        states.driven.pressure_Pa = 101100.0;
        states.driven.temperature_K = 294.15;
        conditions.states = states;
        conditions.step_Pa = stepOf_Pa(shot);
        conditions.plateau_s = 1.63e-3;
        result->shots.push_back(std::move(conditions));
    }
    return result;
}

inline std::shared_ptr<const ResponseResult> responseResult(const Size &size)
{
    auto result = std::make_shared<ResponseResult>();
    result->fLow_Hz = 1.0 / size.window_s;
    result->fHigh_Hz = 4e6;
    result->unit = "V/Pa";
    const Index count = size.frequencies;
    result->frequency_Hz.resize(count);
    for (Eigen::VectorXd *values : {&result->magnitude, &result->u_magnitude, &result->phase_rad,
             &result->u_phase_rad, &result->modelMagnitude, &result->modelPhase_rad})
        values->resize(count);
    for (Index i = 0; i < count; ++i) {
        const double f = result->fLow_Hz
            * std::pow(result->fHigh_Hz / result->fLow_Hz,
                static_cast<double>(i) / static_cast<double>(count - 1));
        const std::complex<double> g = kSensitivity_V_Pa * response(f);
        result->frequency_Hz[i] = f;
        result->modelMagnitude[i] = std::abs(g);
        result->modelPhase_rad[i] = std::arg(g);
        result->magnitude[i] = std::abs(g) * (1.0 + 0.003 * std::sin(7.0 * static_cast<double>(i)));
        result->u_magnitude[i] = 0.004 * std::abs(g);
        result->phase_rad[i] = std::arg(g) + 0.002;
        result->u_phase_rad[i] = 0.004;
    }
    result->u_noiseMagnitude = result->u_magnitude;
    result->u_noisePhase_rad = result->u_phase_rad;
    for (Eigen::VectorXd *none :
        {&result->u_frontMagnitude, &result->boundEnd, &result->boundAlias})
        none->setZero(count);
    result->dof.setConstant(count, std::numeric_limits<double>::infinity());
    constexpr Index kCurve = 600;
    ResponseCurve &curve = result->modelCurve;
    curve.frequency_Hz.resize(kCurve);
    curve.magnitude.resize(kCurve);
    curve.phase_rad.resize(kCurve);
    for (Index i = 0; i < kCurve; ++i) {
        const double f = 0.5 * result->fLow_Hz
            * std::pow(6.0 * result->fHigh_Hz / result->fLow_Hz, static_cast<double>(i) / kCurve);
        curve.frequency_Hz[i] = f;
        curve.magnitude[i] = std::abs(kSensitivity_V_Pa * response(f));
        curve.phase_rad[i] = std::arg(response(f));
    }
    result->characteristics = {7.2e-8, 93.9, 1.0e-5, 508e3, 702e3, 3.6e6};
    for (Index shot = 1; shot <= 3; ++shot)
        result->shots.push_back({shot, kSensitivity_V_Pa, "V/Pa"});
    result->sensitivity = kSensitivity_V_Pa;
    result->sensitivityUnit = "V/Pa";
    return result;
}

/// Every u of these results, taken as complete: for what prints them.
inline std::shared_ptr<const UncertaintyReport> uncertaintyOf(const CalibrationResults &results)
{
    auto report = std::make_shared<UncertaintyReport>();
    const auto add = [](const char *of, double value, double u, double k, const char *unit) {
        ReportedValue one{of, value, unit};
        if (std::isfinite(u))
            one.u = u;
        one.k = k;
        return one;
    };
    if (const auto sensor = sensorResonance(results.model.get(), results.assessment.get()))
        report->ofModel = {add("f0_hz", sensor->frequency_Hz, sensor->u_frequency_Hz,
                               sensor->coverageFactor, "Hz"),
            add("damping_ratio", sensor->dampingRatio, sensor->u_dampingRatio,
                sensor->coverageFactor, "")};
    if (!results.response)
        return report;
    const ResponseResult &response = *results.response;
    const std::string &unit = response.sensitivityUnit;
    const auto ofMean = [&](const SensitivityMean &mean) {
        return add("sensitivity", mean.value, mean.u.value_or(kUnknown), mean.k, unit.c_str());
    };
    if (response.summary.mean)
        report->sensitivity = ofMean(*response.summary.mean);
    for (const SensitivityMean &level : response.summary.perLevel)
        report->perLevel.push_back(ofMean(level));
    for (const ShotSensitivity &shot : response.shots)
        report->ofShots.push_back(add("sensitivity", shot.sensitivity.value_or(kUnknown),
            shot.u.value_or(kUnknown), shot.k, unit.c_str()));
    RowUncertainty &rows = report->rows;
    rows.u_magnitude = response.u_magnitude;
    rows.u_phase_rad = response.u_phase_rad;
    rows.k_magnitude = rows.k_phase = Eigen::VectorXd::NullaryExpr(
        response.u_magnitude.size(), [&](Index row) { return coverageFactorAt(response, row); });
    return report;
}

inline CalibrationResults calibration(const Size &size = {})
{
    CalibrationResults results;
    results.captures = captures(size);
    results.window = window(size);
    results.spectrum = spectrum(size);
    results.components = components(size);
    results.input = modelInput(size);
    results.decomposition = decomposition();
    results.model = model(*results.input);
    results.assessment = assessment(*results.model);
    results.shock = shock();
    results.response = responseResult(size);
    results.uncertainty = uncertaintyOf(results);
    return results;
}

/// Every field that a certificate needs.
inline std::map<std::string, std::string> certificateFields()
{
    return {{"certificate_number", "D-2026-0117"}, {"laboratory", "Dynamic Pressure Laboratory"},
        {"laboratory_address", "Brinellgatan 4, 504 62 Bor\xC3\xA5s, Sweden"},
        {"customer", "Example Motors AB"},
        {"customer_address", "Testv\xC3\xA4gen 1, 123 45 Exempelstad"},
        {"sensor_description", "Fibre-optic pressure sensor, flush mounted, no visible damage"},
        {"place", "Bor\xC3\xA5s"}, {"date_received", "2026-11-02"},
        {"date_performed", "2026-11-20"}, {"date_issued", "2026-11-21"},
        {"operator", "A. Operator"}, {"method_id", "DPL-07, dynamic calibration by shock tube"}};
}

} // namespace dyncal::example
