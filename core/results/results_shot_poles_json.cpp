// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_shot_poles_json.h"

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

/// Mean of the sensitivities of these shots, where all are known.
std::optional<double> sensitivityOf(const std::vector<Index> &shots, const ResultsContext &context)
{
    const auto response = context.results().response;
    double sum = 0.0;
    std::size_t found = 0;
    for (const ShotSensitivity &one : response ? response->shots : std::vector<ShotSensitivity>()) {
        for (const Index shot : shots) {
            if (one.shot == shot && one.sensitivity) {
                sum += *one.sensitivity;
                ++found;
            }
        }
    }
    if (found == 0 || found != shots.size())
        return std::nullopt;
    return sum / static_cast<double>(found);
}

Json levelJson(const LevelPole &level, const ResultsContext &context)
{
    const char *notFitted
        = "The poles could not be fitted to these shots alone, or none of them oscillates.";
    JsonRecord record;
    record.set("shots", level.shots);
    record.text("level", shotLevelName(level.level), "The shot carries no level.");
    record.number("step", level.step, "Not determined.");
    record.number("frequency_hz", level.frequency_Hz, notFitted);
    record.number("u_frequency_hz", level.u_frequency_Hz, notFitted);
    record.number("damping_ratio", level.dampingRatio, notFitted);
    record.number("u_damping_ratio", level.u_dampingRatio, notFitted);
    record.number("plateau_gain", level.plateauGain, notFitted);
    record.number("u_plateau_gain", level.u_plateauGain, notFitted);
    record.number("coverage_factor", level.coverageFactor, notFitted);
    record.number("sensitivity", sensitivityOf(level.shots, context),
        "There is no pressure step for every one of these shots.");
    return record.take();
}

Json levelsJson(const std::vector<LevelPole> &levels, const ResultsContext &context)
{
    Json list = Json::array();
    for (const LevelPole &level : levels)
        list.push_back(levelJson(level, context));
    return list;
}

Json homogeneityJson(const Homogeneity &test)
{
    JsonRecord record;
    record.number("frequency_hz", test.frequency_Hz, "Not determined.");
    record.number("chi_square", test.statistic, "Not determined.");
    record.number("degrees_of_freedom", test.dof, "Not determined.");
    record.number("probability", test.probability, "Not determined.");
    record.set("passed", test.passed);
    return record.take();
}

Json secondOrderJson(const SecondOrderModel &fit)
{
    const char *unknown = "Not determined.";
    JsonRecord record;
    record.number("f0_hz", fit.f0_Hz, unknown);
    record.number("u_f0_hz", fit.u_f0_Hz, unknown);
    record.number("zeta", fit.zeta, unknown);
    record.number("u_zeta", fit.u_zeta, unknown);
    record.number("coverage_factor", fit.coverageFactor, unknown);
    record.set("uncertainty_method", fit.uncertaintyMethod);
    record.number("fit_percent", fit.fit_percent, unknown);
    record.number("residual_to_noise", fit.residualToNoise, unknown);
    record.set("describes", fit.describes);
    record.set("is_model", fit.isModel);
    Json shots = Json::array();
    for (const SecondOrderShot &shot : fit.shots) {
        JsonRecord one;
        one.set("shot", shot.shot);
        one.number("plateau_gain", shot.plateauGain, unknown);
        one.number("u_plateau_gain", shot.u_plateauGain, unknown);
        one.number("onset_s", shot.onset_s, unknown);
        one.number("u_onset_s", shot.u_onset_s, unknown);
        one.number("fit_percent", shot.fit_percent, unknown);
        shots.push_back(one.take());
    }
    record.set("shots", std::move(shots));
    return record.take();
}

} // namespace

void addShotPoles(JsonRecord &section, const ResultsContext &context)
{
    const CalibrationResults &results = context.results();
    section.text("uncertainty_method", results.model->uncertaintyMethod, kNoUncertainty);
    static const ModelAssessment nothing; // for a model that is not assessed
    const ModelAssessment &found = results.assessment ? *results.assessment : nothing;
    if (found.homogeneity)
        section.set("homogeneity", homogeneityJson(*found.homogeneity));
    else
        section.missing("homogeneity",
            "Fewer than two shots, or no pole that could be fitted to two of them alone.");
    section.set("per_shot", levelsJson(found.perShot, context));
    section.set("per_level", levelsJson(found.perLevel, context));
    if (found.secondOrder)
        section.set("second_order", secondOrderJson(*found.secondOrder));
    else
        section.missing("second_order",
            "Fitted only to step responses with refinement, and only where the fit converges.");
}

} // namespace dyncal
