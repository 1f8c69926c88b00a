// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_sensitivity_json.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using SensitivityJson = JsonRecord::Json;

constexpr const char *kIncomplete
    = "Not complete: the uncertainty of the pressure step or of the level at the onset is not known.";
constexpr const char *kInfiniteDof = "Infinite.";

/// The value, and its complete uncertainty; null: not evaluated.
void addMean(JsonRecord &record, const SensitivityMean &mean, const ReportedValue *reported)
{
    const bool known = reported && reported->u;
    record.number("value", mean.value, "Not finite.");
    record.number("u", known ? reported->u : std::nullopt, kIncomplete);
    record.number("k", known ? std::optional(reported->k) : std::nullopt, kIncomplete);
    record.number("dof", known ? std::optional(reported->dof) : std::nullopt,
        known ? kInfiniteDof : kIncomplete);
}

SensitivityJson levelsJson(
    const std::vector<SensitivityMean> &levels, const UncertaintyReport *report)
{
    SensitivityJson list = SensitivityJson::array();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        JsonRecord record;
        record.set("level", shotLevelName(levels[i].level));
        addMean(record, levels[i], levelOf(report, i));
        list.push_back(record.take());
    }
    return list;
}

} // namespace

void addSensitivitySummary(JsonRecord &root, const ResultsContext &context)
{
    const ResponseResult *response = context.results().response.get();
    if (!response || !response->summary.mean) {
        root.missing("sensitivity",
            response
                ? "Not determined: the level or the pressure step of a shot is not known, or the shots differ in unit."
                : context.whyMissing());
        return;
    }
    const SensitivitySummary &summary = response->summary;
    JsonRecord section;
    const UncertaintyReport *report = context.results().uncertainty.get();
    addMean(
        section, *summary.mean, report && report->sensitivity ? &*report->sensitivity : nullptr);
    section.set("unit", response->sensitivityUnit);
    section.set("per_level", levelsJson(summary.perLevel, report));
    const char *uncompared = "Fewer than two shots, or their uncertainties are not known.";
    section.number("homogeneity_p", summary.homogeneity_p, uncompared);
    section.set("shots_agree", summary.shotsAgree);
    const char *noTrend = summary.homogeneity_p ? "The steps are alike." : uncompared;
    section.number("linearity_per_pa", summary.linearity_per_Pa, noTrend);
    section.number("u_linearity_per_pa", summary.uLinearity_per_Pa, noTrend);
    root.set("sensitivity", section.take());
}

void addDrift(JsonRecord &root, const ResultsContext &context)
{
    const ResponseResult *response = context.results().response.get();
    if (!response) {
        root.missing("drift", context.whyMissing());
        return;
    }
    SensitivityJson list = SensitivityJson::array();
    for (const ShotDrift &drift : response->drift.shots) {
        JsonRecord record;
        record.set("shot", drift.shot);
        record.number("tau_s", drift.tau_s, "Longer than the model input can tell.");
        record.number("share", drift.share, "Not finite.");
        record.number("relative", drift.relative, "Not finite.");
        record.number("u", drift.u, "Not known.");
        record.number("at_s", drift.at_s, "Not known.");
        record.set("attributed_to", driftKindName(response->drift.kind));
        list.push_back(record.take());
    }
    root.set("drift", std::move(list));
}

void addEchoes(JsonRecord &root, const ResultsContext &context)
{
    const ModelInput *input = context.results().input.get();
    if (!input) {
        root.missing("echo", context.whyMissing());
        return;
    }
    SensitivityJson list = SensitivityJson::array();
    for (const Echo &echo : input->echoes.ofShots) {
        JsonRecord record;
        record.set("shot", echo.shot);
        record.number("delay_s", echo.delay_s, "Not known.");
        record.number("u_delay_s", echo.u_delay_s, "Not known.");
        record.number("relative", echo.relative, "Not known.");
        record.number("u", echo.u_relative, "Not known.");
        record.number("records_end_s", input->echoes.recordsEnd_s,
            "The end that was set for window or model input lies behind the echo.");
        list.push_back(record.take());
    }
    root.set("echo", std::move(list));
}

void addShotSensitivity(JsonRecord &record, Index shot, const ResultsContext &context)
{
    const char *undetermined
        = "Not determined: the shot's pressure step is not known, or the level of its response at the onset not to 10 %.";
    const ResponseResult *response = context.results().response.get();
    const ShotSensitivity *found = nullptr;
    std::size_t at = 0;
    for (std::size_t i = 0; response && i < response->shots.size(); ++i) {
        if (response->shots[i].shot == shot) {
            found = &response->shots[i];
            at = i;
        }
    }
    const std::string reason = response ? undetermined : context.whyMissing();
    const bool known = found && found->sensitivity;
    record.number("sensitivity", found ? found->sensitivity : std::nullopt, reason);
    record.text("sensitivity_unit", known ? found->unit : std::string(), reason);
    const std::string incomplete = known ? kIncomplete : reason;
    const UncertaintyReport *report = context.results().uncertainty.get();
    const double u = found ? uOfShot(report, at) : kUnknown;
    record.number("u_sensitivity", u, incomplete);
    record.number("k_sensitivity", found ? kOfShot(report, at) : kUnknown, incomplete);
    record.number("u_level_relative", known ? found->uLevel_relative : kUnknown, incomplete);
}

} // namespace dyncal
