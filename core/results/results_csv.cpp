// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_csv.h"

#include "core/decomposition/component_result.h"
#include "core/results/csv_table.h"

#include <algorithm>

namespace dyncal {
namespace {

std::string threeDigits(Index number)
{
    const std::string digits = std::to_string(number);
    return digits.size() < 3 ? std::string(3 - digits.size(), '0') + digits : digits;
}

/// "shot_001", or "average" for 0.
std::string seriesName(Index shot)
{
    return shot > 0 ? std::string("shot_").append(threeDigits(shot)) : "average";
}

/// Times first, first + 1/rate, ...
Eigen::VectorXd times(double first_s, double rate_Hz, Index count)
{
    return Eigen::VectorXd::NullaryExpr(
        count, [=](Index i) { return first_s + static_cast<double>(i) / rate_Hz; });
}

void addResponses(std::vector<CsvFile> &files, const WindowResult &window)
{
    for (const WindowedResponse &response : window.responses) {
        CsvTable table;
        table.add("time_s", times(0.0, response.sampleRate_Hz, response.length));
        table.add("value", response.window());
        files.push_back({"response_" + seriesName(response.shot) + ".csv", table.text()});
    }
}

void addSpectra(
    std::vector<CsvFile> &files, const SpectrumResult &spectrum, const WindowResult &window)
{
    const std::size_t count = std::min(spectrum.perShot.size(), window.responses.size());
    for (std::size_t i = 0; i < count; ++i) {
        const PowerSpectrum &psd = spectrum.perShot[i];
        CsvTable table;
        table.add("frequency_hz", psd.frequency_Hz);
        table.add("psd_per_hz", psd.psd);
        table.add("psd_db", Eigen::VectorXd(10.0 * psd.psd.array().log10()));
        files.push_back(
            {"spectrum_" + seriesName(window.responses[i].shot) + ".csv", table.text()});
    }
}

void addComponents(std::vector<CsvFile> &files, const ComponentResult &components)
{
    CsvTable table;
    table.add("time_s", times(0.0, components.sampleRate_Hz, components.responses.rows()));
    for (Index i = 0; i < components.responses.cols(); ++i)
        table.add(seriesName(components.shots[static_cast<std::size_t>(i)]) + "_response",
            components.responses.col(i));
    for (Index i = 0; i < components.reconstructions.cols(); ++i)
        table.add(seriesName(components.shots[static_cast<std::size_t>(i)]) + "_reconstruction",
            components.reconstructions.col(i));
    table.add("average", components.average);
    if (components.principal) {
        const Eigen::MatrixXd &principal = components.principal->components;
        for (Index i = 0; i < principal.cols(); ++i)
            table.add("component_" + std::to_string(i + 1), principal.col(i));
    }
    files.push_back({"components.csv", table.text()});
}

void addModelInput(std::vector<CsvFile> &files, const ModelInput &input)
{
    for (const ModelSeries &series : input.series) {
        CsvTable table;
        table.add("time_s", times(series.first_s, input.sampleRate_Hz, series.y.size()));
        table.add("value", series.y);
        files.push_back({"model_input_" + seriesName(series.shot) + ".csv", table.text()});
    }
}

void addSingularValues(std::vector<CsvFile> &files, const HankelDecomposition &hankel)
{
    CsvTable table;
    const Index count = hankel.singularValues.size();
    table.add("order", Eigen::VectorXd::LinSpaced(count, 1.0, static_cast<double>(count)));
    table.add("singular_value", hankel.singularValues);
    files.push_back({"singular_values.csv", table.text()});
}

/// One row per order; a value that an order does not have is an empty cell.
void addOrders(std::vector<CsvFile> &files, const OrderEvidence &evidence)
{
    const Index count = evidence.fit_percent.size();
    CsvTable table;
    table.add("order", Eigen::VectorXd::LinSpaced(count, 1.0, static_cast<double>(count)));
    table.add("fit_percent", evidence.fit_percent);
    table.add("leave_one_out_percent", evidence.crossShot_percent);
    files.push_back({"orders.csv", table.text()});

    const auto poles = static_cast<Index>(evidence.poles.size());
    const auto column = [&](auto value) {
        return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(
            poles, [&](Index i) { return value(evidence.poles[static_cast<std::size_t>(i)]); }));
    };
    CsvTable stability;
    stability.add("order", column([](const OrderPole &p) { return static_cast<double>(p.order); }));
    stability.add("frequency_hz", column([](const OrderPole &p) { return p.frequency_Hz; }));
    stability.add("damping_ratio", column([](const OrderPole &p) { return p.dampingRatio; }));
    stability.add(
        "stability", column([](const OrderPole &p) { return static_cast<double>(p.stability); }));
    stability.add("stands_out", column([](const OrderPole &p) { return p.standsOut ? 1.0 : 0.0; }));
    files.push_back({"stability.csv", stability.text()});
}

void addFits(std::vector<CsvFile> &files, const SensorModel &model, const ModelInput &input)
{
    const std::size_t count = std::min(model.series.size(), input.series.size());
    for (std::size_t i = 0; i < count; ++i) {
        const ModelSeries &series = input.series[i];
        CsvTable table;
        table.add("time_s", times(series.first_s, input.sampleRate_Hz, series.y.size()));
        table.add("measured", series.y);
        table.add("model", model.series[i].simulated);
        table.add("error", model.series[i].error);
        files.push_back({"model_" + seriesName(series.shot) + ".csv", table.text()});
    }
}

void addPoles(std::vector<CsvFile> &files, const SensorModel &model)
{
    const auto count = static_cast<Index>(model.poles.size());
    const auto column = [&](auto value) {
        return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(
            count, [&](Index i) { return value(model.poles[static_cast<std::size_t>(i)]); }));
    };
    CsvTable table;
    table.add("z_re", column([](const Pole &p) { return p.z.real(); }));
    table.add("z_im", column([](const Pole &p) { return p.z.imag(); }));
    table.add("frequency_hz", column([](const Pole &p) { return p.frequency_Hz; }));
    table.add("damping_ratio", column([](const Pole &p) { return p.dampingRatio; }));
    table.add("amplitude", column([](const Pole &p) { return p.amplitude; }));
    files.push_back({"poles.csv", table.text()});
}

void addFrequencyResponse(
    std::vector<CsvFile> &files, const ResponseResult &response, const UncertaintyReport *report)
{
    const RowUncertainty rows
        = report && response.magnitude.size() > 0 ? report->rows : RowUncertainty();
    CsvTable table;
    table.add("frequency_hz", response.frequency_Hz);
    table.add("magnitude", response.magnitude);
    table.add("u_magnitude", rows.u_magnitude);
    table.add("phase_rad", response.phase_rad);
    table.add("u_phase_rad", rows.u_phase_rad);
    table.add("model_magnitude", response.modelMagnitude);
    table.add("model_phase_rad", response.modelPhase_rad);
    table.add("u_noise_magnitude", response.u_noiseMagnitude);
    table.add("u_noise_phase_rad", response.u_noisePhase_rad);
    table.add("bound_end", response.boundEnd);
    table.add("bound_alias", response.boundAlias);
    table.add("k_magnitude", rows.k_magnitude);
    table.add("k_phase", rows.k_phase);
    table.add("var_re", rows.covarianceReIm.col(0));
    table.add("cov_re_im", rows.covarianceReIm.col(1));
    table.add("var_im", rows.covarianceReIm.col(2));
    table.add("u_model_magnitude", rows.u_modelMagnitude);
    table.add("u_model_phase_rad", rows.u_modelPhase_rad);
    table.add("e_n", rows.e_n);
    files.push_back({"frequency_response.csv", table.text()});
    CsvTable curve;
    curve.add("frequency_hz", response.modelCurve.frequency_Hz);
    curve.add("magnitude", response.modelCurve.magnitude);
    curve.add("phase_rad", response.modelCurve.phase_rad);
    files.push_back({"model_curve.csv", curve.text()});
}

} // namespace

std::vector<CsvFile> resultsCsv(const CalibrationResults &results)
{
    std::vector<CsvFile> files;
    if (results.window)
        addResponses(files, *results.window);
    if (results.spectrum && results.window)
        addSpectra(files, *results.spectrum, *results.window);
    if (results.components)
        addComponents(files, *results.components);
    if (results.input)
        addModelInput(files, *results.input);
    if (results.decomposition)
        addSingularValues(files, results.decomposition->hankel);
    if (results.model && results.input)
        addFits(files, *results.model, *results.input);
    if (results.model)
        addPoles(files, *results.model);
    if (results.evidence)
        addOrders(files, *results.evidence);
    if (results.response)
        addFrequencyResponse(files, *results.response, results.uncertainty.get());
    return files;
}

} // namespace dyncal
