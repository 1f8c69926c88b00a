// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_model_json.h"

#include "core/base/constants.h"
#include "core/realization/model/pole_classes.h"
#include "core/results/pole_json.h"
#include "core/results/results_shot_poles_json.h"

#include <algorithm>

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

void addStateSpace(JsonRecord &section, const StateSpaceModel &model)
{
    section.number("dt_s", model.sampleInterval_s, "Not determined.");
    const auto matrix = [&section](const char *key, const Eigen::MatrixXd &values) {
        section.set(key, rowsOf(values));
        if (!values.allFinite())
            section.set(std::string(key) + "_reason", "null where the model diverges.");
    };
    matrix("A", model.A);
    matrix("B", model.B);
    matrix("C", model.C);
    matrix("D", model.D);
}

void addFits(JsonRecord &section, const SensorModel &model)
{
    const char *diverges = "The simulation of the model diverges.";
    const auto fit
        = [&model](double percent) { return model.diverges ? std::optional<double>() : percent; };
    section.number("fit_percent", fit(model.fit_percent), diverges);
    section.number("fit_attainable_percent", model.fitAttainable_percent,
        "There is too little record before the start to know the noise.");
    section.number("fit_listing_percent",
        model.diverges ? std::optional<double>() : model.fitListing_percent,
        model.fitListing_percent ? diverges
                                 : "Only the treatment step-as-impulse has the listing's FIT.");
    const bool ofAverage = model.series.size() == 1 && model.series.front().shot == 0;
    Eigen::VectorXd fits(ofAverage ? 0 : static_cast<Index>(model.series.size()));
    for (Index i = 0; i < fits.size(); ++i)
        fits[i] = model.diverges ? kUnknown : model.series[static_cast<std::size_t>(i)].fit_percent;
    section.numbers("fit_per_shot_percent", fits,
        ofAverage ? "The model describes the average of the shots." : diverges);
}

Json nuisanceOfShotJson(const NuisanceOfShot &shot)
{
    JsonRecord record;
    record.set("shot", shot.shot);
    record.number("frequency_hz", shot.term.frequency_Hz(), "Not determined.");
    record.number("u_frequency_hz", shot.u_frequency_Hz, kNoUncertainty);
    record.number("damping_ratio", shot.term.dampingRatio(), "Not determined.");
    record.number("u_damping_ratio", shot.u_dampingRatio, kNoUncertainty);
    record.number("amplitude", shot.relativeAmplitude, "Not determined.");
    record.number("phase_rad", shot.phase_rad, "Not determined.");
    return record.take();
}

Json effectSideJson(const NuisanceEffect::Side &side)
{
    const char *noResonance = "The model does not oscillate.";
    JsonRecord record;
    record.number("residual_rms", side.residualRms, "Not determined.");
    record.number("fit_percent", side.fit_percent, "Not determined.");
    record.number("f0_hz", side.f0_Hz, noResonance);
    record.number("u_f0_hz", side.u_f0_Hz, kNoUncertainty);
    record.number("damping_ratio", side.zeta, noResonance);
    record.number("u_damping_ratio", side.u_zeta, kNoUncertainty);
    record.number("plateau_gain", side.plateauGain, "Not determined.");
    return record.take();
}

/// Modes of the recipe that were fitted beside the sensor and left out of the model.
Json nuisanceJson(const SensorModel &model)
{
    Json modes = Json::array();
    for (const NuisanceResult &mode : model.nuisance) {
        Json shots = Json::array();
        for (const NuisanceOfShot &shot : mode.perShot)
            shots.push_back(nuisanceOfShotJson(shot));
        modes.push_back({{"kind", mode.mode.isTube ? "tube" : "other"}, {"label", mode.mode.label},
            {"reason", mode.mode.reason}, {"per_shot", std::move(shots)}});
    }
    return modes;
}

/// Unit of c0: 1 for a response remapped to 0..1, else that of the recordings.
std::string gainUnit(const ResultsContext &context)
{
    if (context.recipe.remap && isStepTreatment(context.recipe.input.treatment))
        return "1";
    const auto window = context.results().window;
    return window && !window->responses.empty() ? window->responses.front().unit : "";
}

/// Every pole with what is stated of it.
Json polesJson(const CalibrationResults &results)
{
    const SensorModel &model = *results.model;
    const std::vector<Pole> &poles = polesOf(model, results.assessment.get());
    const std::vector<PoleUncertainty> stated
        = statedPoles(model, results.assessment.get(), results.uncertainty.get());
    Json list = Json::array();
    for (const std::size_t i : listedPoles(poles))
        list.push_back(statedPoleJson(poles[i], stated[i]));
    return list;
}

} // namespace

void addModel(JsonRecord &root, const ResultsContext &context)
{
    const auto &model = context.results().model;
    const ModelAssessment *assessment = context.results().assessment.get();
    if (!model) {
        root.missing("model", context.whyMissing());
        return;
    }
    JsonRecord section;
    section.set("order", model->order);
    addStateSpace(section, model->stateSpace);
    section.set("poles", polesJson(context.results()));
    Json zeros = Json::array();
    for (const std::complex<double> &zero : model->zeros)
        zeros.push_back({{"re", finiteOrNull(zero.real())}, {"im", finiteOrNull(zero.imag())}});
    section.set("zeros", std::move(zeros));
    addFits(section, *model);
    section.number("plateau_gain", isPlateauKnown(*model) ? model->plateauGain : kUnknown,
        "The response drifts: where it would end is not known well enough.");
    section.number("onset_level", model->level(), "The level could not be fitted.");
    section.text("gain_unit", gainUnit(context), "The recordings state no unit.");
    section.set("nuisance", nuisanceJson(*model));
    if (assessment && assessment->nuisanceEffect)
        section.set("nuisance_effect",
            Json{{"before", effectSideJson(assessment->nuisanceEffect->before)},
                {"after", effectSideJson(assessment->nuisanceEffect->after)}});
    else
        section.missing("nuisance_effect",
            "No oscillation was left out, or the model without it could not be refined.");
    addShotPoles(section, context);
    root.set("model", section.take());
}

} // namespace dyncal
