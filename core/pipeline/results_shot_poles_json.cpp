// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/results_sections.h"

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
    const char *notFitted = "The poles could not be fitted to these shots alone, or none of them "
                            "oscillates.";
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

} // namespace

void addShotPoles(JsonRecord &section, const ResultsContext &context)
{
    const SensorModel &model = *context.results().model;
    section.text("uncertainty_method", model.uncertaintyMethod, kNoUncertainty);
    if (model.homogeneity)
        section.set("homogeneity", homogeneityJson(*model.homogeneity));
    else
        section.missing("homogeneity", "Fewer than two shots could be fitted alone.");
    section.set("per_shot", levelsJson(model.perShot, context));
    section.set("per_level", levelsJson(model.perLevel, context));
}

} // namespace dyncal
