// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/model_export.h"

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/results/csv_table.h"
#include "core/results/json_record.h"
#include "core/results/mat_writer.h"
#include "core/results/model_scripts.h"
#include "core/results/pole_json.h"
#include "core/results/results_context.h"
#include "core/uncertainty/stated_poles.h"

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

/// c_i and s_i as they are exported; the step's own pole has no amplitude.
struct Exponentials
{
    Eigen::VectorXcd c;
    Eigen::VectorXcd s;
};

Exponentials exponentialsOf(const SensorModel &model)
{
    Exponentials sum{model.amplitudes, Eigen::VectorXcd(model.amplitudes.size())};
    for (Index i = 0; i < sum.s.size(); ++i)
        sum.s[i] = model.poles[static_cast<std::size_t>(i)].s_rad_s;
    return sum;
}

bool canLeave(const SensorModel &model)
{
    const StateSpaceModel &space = model.stateSpace;
    return !model.diverges && space.A.allFinite() && space.B.allFinite() && space.C.allFinite()
        && space.D.allFinite() && model.amplitudes.allFinite();
}

/// Measured and simulated series, one column each.
Eigen::MatrixXd columnsOf(const std::vector<SeriesFit> &series, const ModelInput *input)
{
    Eigen::MatrixXd columns(series.front().simulated.size(), static_cast<Index>(series.size()));
    for (Index r = 0; r < columns.cols(); ++r) {
        const auto at = static_cast<std::size_t>(r);
        columns.col(r) = input ? input->series[at].y : series[at].simulated;
    }
    return columns;
}

std::string matFile(const SensorModel &model, const ModelInput &input)
{
    const Exponentials sum = exponentialsOf(model);
    MatWriter file;
    file.add("A", model.stateSpace.A);
    file.add("B", model.stateSpace.B);
    file.add("C", model.stateSpace.C);
    file.add("D", model.stateSpace.D);
    file.add("Ts", model.stateSpace.sampleInterval_s);
    file.add("fs", input.sampleRate_Hz);
    file.add("c0", model.plateauGain);
    file.add("c", Eigen::MatrixXcd(sum.c));
    file.add("s", Eigen::MatrixXcd(sum.s));
    file.add("y", columnsOf(model.series, &input));
    file.add("y_model", columnsOf(model.series, nullptr));
    return file.bytes();
}

Json complexList(const Eigen::VectorXcd &values)
{
    Json list = Json::array();
    for (const std::complex<double> &value : values)
        list.push_back({{"re", finiteOrNull(value.real())}, {"im", finiteOrNull(value.imag())}});
    return list;
}

/// In the order of `s_rad_s`; the step's own pole, which is none of these, last.
Json poleList(const CalibrationResults &results)
{
    const std::vector<Pole> &poles = polesOf(*results.model, results.assessment.get());
    const std::vector<PoleUncertainty> stated
        = statedPoles(*results.model, results.assessment.get(), results.uncertainty.get());
    Json list = Json::array();
    for (std::size_t i = 0; i < poles.size(); ++i)
        list.push_back(statedPoleJson(poles[i], stated[i]));
    return list;
}

/// Where each series begins and what it tends to.
Json seriesList(const std::vector<SeriesFit> &series)
{
    const char *unrefined = "The model was not refined.";
    Json list = Json::array();
    for (const SeriesFit &fit : series) {
        JsonRecord record;
        record.set("shot", fit.shot);
        record.number("c0", fit.plateauGain, "The plateau could not be fitted.");
        record.number("u_c0", fit.u_plateauGain, unrefined);
        record.number("onset_level", fit.level(), "The level could not be fitted.");
        record.number("u_onset_level", fit.u_level(), unrefined);
        record.number("onset_s", fit.onset_s, "Not determined.");
        record.number("u_onset_s", fit.u_onset_s, unrefined);
        list.push_back(record.take());
    }
    return list;
}

void addSensitivity(JsonRecord &root, const CalibrationResults &results)
{
    const ResponseResult *response = results.response.get();
    const char *noStep = "No pressure step is known.";
    const bool known = response && response->sensitivity;
    root.number("sensitivity", known ? response->sensitivity : std::nullopt, noStep);
    root.text("sensitivity_unit", known ? response->sensitivityUnit : std::string(), noStep);
    const std::string none = known ? "The uncertainty of a shot is not known." : noStep;
    const bool complete = known && results.uncertainty && results.uncertainty->sensitivity
        && results.uncertainty->sensitivity->u;
    root.number(
        "u_sensitivity", complete ? results.uncertainty->sensitivity->u : std::nullopt, none);
    root.number("k_sensitivity",
        complete ? std::optional(results.uncertainty->sensitivity->k) : std::nullopt, none);
}

std::string jsonFile(const SensorModel &model, const CalibrationResults &results)
{
    const Exponentials sum = exponentialsOf(model);
    JsonRecord root;
    root.set("schema", "dyncal-model/1");
    root.set("software", std::string("dyncal ") + versionText());
    root.set("treatment", responseTreatmentName(results.input->treatment));
    root.set("order", model.order);
    root.number("dt_s", model.stateSpace.sampleInterval_s, "Not determined.");
    root.set("A", rowsOf(model.stateSpace.A));
    root.set("B", rowsOf(model.stateSpace.B));
    root.set("C", rowsOf(model.stateSpace.C));
    root.set("D", rowsOf(model.stateSpace.D));
    root.number("c0", model.plateauGain, "The plateau could not be fitted.");
    root.number("onset_level", model.level(), "The level could not be fitted.");
    root.set("c", complexList(sum.c));
    root.set("s_rad_s", complexList(sum.s));
    root.set("poles", poleList(results));
    root.set("series", seriesList(model.series));
    addSensitivity(root, results);
    return jsonText(root.take());
}

std::string matrixCsv(const Eigen::MatrixXd &matrix)
{
    std::string text;
    for (const auto &row : matrix.rowwise()) {
        for (Index i = 0; i < row.size(); ++i)
            text += std::string(i > 0 ? "," : "") + exactNumber(row[i]);
        text += '\n';
    }
    return text;
}

/// The constant is the exponential of rate 0.
std::string exponentialsCsv(const SensorModel &model)
{
    const Exponentials sum = exponentialsOf(model);
    const auto column = [](double first, const Eigen::VectorXd &rest) {
        Eigen::VectorXd values(rest.size() + 1);
        values << first, rest;
        return values;
    };
    CsvTable table;
    table.add("s_re_rad_s", column(0.0, sum.s.real()));
    table.add("s_im_rad_s", column(0.0, sum.s.imag()));
    table.add("c_re", column(model.plateauGain, sum.c.real()));
    table.add("c_im", column(0.0, sum.c.imag()));
    return table.text();
}

} // namespace

std::vector<ModelFile> modelFiles(const CalibrationResults &results)
{
    if (!results.model || !results.input || !canLeave(*results.model))
        return {};
    const SensorModel &model = *results.model;
    const ResponseTreatment treatment = results.input->treatment;
    return {{"model.mat", "mat", matFile(model, *results.input)},
        {"model.json", "json", jsonFile(model, results)},
        {"A.csv", "csv", matrixCsv(model.stateSpace.A)},
        {"B.csv", "csv", matrixCsv(model.stateSpace.B)},
        {"C.csv", "csv", matrixCsv(model.stateSpace.C)},
        {"D.csv", "csv", matrixCsv(model.stateSpace.D)},
        {"exponentials.csv", "csv", exponentialsCsv(model)},
        {"model.m", "m", matlabScript(treatment)}, {"model.py", "py", pythonScript(treatment)}};
}

const std::vector<std::string> &modelFileNames()
{
    static const std::vector<std::string> names{"model.mat", "model.json", "A.csv", "B.csv",
        "C.csv", "D.csv", "exponentials.csv", "model.m", "model.py"};
    return names;
}

const std::vector<std::string> &modelFormats()
{
    static const std::vector<std::string> formats{"mat", "json", "csv", "m", "py"};
    return formats;
}

} // namespace dyncal
