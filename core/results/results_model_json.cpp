// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_model_json.h"

#include "core/base/constants.h"
#include "core/model_analysis/stated_characteristics.h"
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

void addCurves(JsonRecord &section, const ResponseResult &response)
{
    const char *none = response.magnitude.size() == 0
        ? "This treatment of the response gives no frequency response of a step."
        : "The records do not hold frequencies above 0.4 of the lowest sample rate.";
    const char *noModel
        = "The model gives no response here: it diverges, or of a free decay the frequency is above half the model's rate.";
    section.numbers("frequency_hz", response.frequency_Hz,
        "None of the frequencies asked for lies in the usable band.");
    section.numbers("magnitude", response.magnitude, none);
    section.numbers("u_magnitude", response.u_magnitude, none);
    section.missing("k_magnitude", kNoUncertainty);
    section.set("u_contains_step", false); // it contains the noise of the recordings only
    section.numbers("phase_rad", response.phase_rad, none);
    section.numbers("u_phase_rad", response.u_phase_rad, none);
    section.missing("k_phase", kNoUncertainty);
    section.numbers("model_magnitude", response.modelMagnitude, noModel);
    section.numbers("model_phase_rad", response.modelPhase_rad, noModel);
}

/// The edge, or the end of the band of the response that it lies beyond.
void addBand(JsonRecord &section, const std::string &name, const StatedValue &edge)
{
    const std::string reason = english(edge.words);
    const std::string noBound = edge.value ? "The value is stated." : reason;
    section.number(name + "_hz", edge.value, reason);
    section.number(name + "_above_hz", edge.above, noBound);
    section.number(name + "_below_hz", edge.below, noBound);
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
    Json poles = Json::array();
    std::vector<Pole> sorted = polesOf(*model, assessment);
    sortPoles(sorted);
    for (const Pole &pole : sorted)
        poles.push_back(poleJson(pole));
    section.set("poles", std::move(poles));
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

void addResponse(JsonRecord &root, const ResultsContext &context)
{
    const auto response = context.results().response;
    if (!response) {
        root.missing("response", context.whyMissing());
        return;
    }
    JsonRecord section;
    addCurves(section, *response);
    section.number("f_low_hz", response->fLow_Hz, "Not determined.");
    section.number("f_high_hz", response->fHigh_Hz, "Not determined.");
    section.text("unit", response->unit, "The recordings state no unit.");
    root.set("response", section.take());
}

void addBands(JsonRecord &root, const ResultsContext &context)
{
    const auto response = context.results().response;
    if (!response) {
        root.missing("bands", context.whyMissing());
        return;
    }
    const StatedCharacteristics found = statedCharacteristics(*response);
    JsonRecord section;
    addBand(section, "within_5_percent", found.within5percent_Hz);
    addBand(section, "within_10_percent", found.within10percent_Hz);
    addBand(section, "minus_3_db", found.minus3dB_Hz);
    section.number("limit_hz", answersEnd_Hz(*response), "Not determined.");
    section.set("source", "model");
    root.set("bands", section.take());
}

void addBudget(JsonRecord &root)
{
    root.missing("budget",
        "Not evaluated for the frequency response; that of each pressure step is in shock.");
    root.missing("gum_validated_by_monte_carlo",
        "Not evaluated for the frequency response; that of each pressure step is in shock.");
}

} // namespace dyncal
