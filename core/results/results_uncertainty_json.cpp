// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_uncertainty_json.h"

#include "core/results/reported_by_key.h"

#include <string>

namespace dyncal {
namespace {

using UncertaintyJson = JsonRecord::Json;

constexpr const char *kWithheldRow
    = "Withheld (see withheld_reason), or a part of its uncertainty is not known.";

UncertaintyJson lineJson(
    const std::string &of, const UncertaintyLine &line, const ReportedValue &reported)
{
    JsonRecord record;
    record.set("of", of);
    record.set("quantity", line.quantity);
    if (line.shot > 0)
        record.set("shot", line.shot);
    else
        record.missing("shot", "Of all shots.");
    record.number("value", line.value, "Is known by its uncertainty alone.");
    record.number("u", line.u, "Not known.");
    record.set("distribution", distributionName(line.distribution));
    record.number("dof", line.dof, "Infinite.");
    record.number("sensitivity", line.sensitivity, "Not determined.");
    record.number("contribution", line.contribution, "Not determined.");
    record.number("share_percent", reported.sharePercent(line), "Not determined.");
    return record.take();
}

void addLines(const std::string &of, const ReportedValue &reported, UncertaintyJson &list)
{
    for (const UncertaintyLine &line : reported.lines)
        list.push_back(lineJson(of, line, reported));
}

/// The budget of each row of S(f): "response.magnitude[3]", "response.phase_rad[3]"; of those at
/// the marked frequencies with `of` "response.marked", of a comparison "comparison".
void addRowLines(const std::string &of, const ResponseResult &response, const RowUncertainty &rows,
    UncertaintyJson &list)
{
    const std::string magnitude = of + ".magnitude";
    const std::string phase = of + ".phase_rad";
    for (Index i = 0; i < rows.u_phase_rad.size(); ++i) {
        const std::string place = placeOf(static_cast<std::size_t>(i));
        if (std::isfinite(rows.u_magnitude[i]))
            addLines(magnitude + place, magnitudeOfRow(response, rows, i), list);
        if (std::isfinite(rows.u_phase_rad[i]))
            addLines(phase + place, phaseOfRow(response, rows, i), list);
    }
}

void addResponseLines(const std::string &of, const ResponseResult &response,
    const UncertaintyReport &report, UncertaintyJson &list)
{
    if (response.u_noiseMagnitude.size() == report.rows.u_phase_rad.size())
        addRowLines(of, response, report.rows, list);
    if (response.atMarks)
        addRowLines(of + ".marked", *response.atMarks, report.rowsAtMarks, list);
}

/// Of a comparison beside the response by the step; against a transducer it is the response itself.
void addComparisonLines(const CalibrationResults &results, UncertaintyJson &list)
{
    const auto &comparison = results.comparison;
    if (comparison && comparison->byTransducer && !results.response->isByTransducer)
        addResponseLines("comparison", comparison->byTransducer->response,
            comparison->byTransducer->report, list);
}

UncertaintyJson characteristicJson(const ReportedValue &one)
{
    const std::string none = "Not complete: " + english(one.missing) + ".";
    JsonRecord record;
    record.set("quantity", one.of);
    record.number("value", one.value, "Not determined.");
    record.number("u", one.u, none);
    record.number("k", one.u ? std::optional(one.k) : std::nullopt, none);
    record.number("dof", one.u ? std::optional(one.dof) : std::nullopt, one.u ? "Infinite." : none);
    record.set("unit", one.unit.empty() ? "1" : one.unit);
    return record.take();
}

} // namespace

void addRowUncertainty(JsonRecord &section, const ResponseResult &response,
    const RowUncertainty *ofRows, const std::string &whyMissing)
{
    const bool measured = response.magnitude.size() > 0;
    const RowUncertainty rows = ofRows && measured ? *ofRows : RowUncertainty();
    const std::string none = !measured
        ? "This treatment of the response gives no frequency response of a step."
        : ofRows ? kWithheldRow
                 : whyMissing;
    section.numbers("u_magnitude", rows.u_magnitude, none);
    section.numbers("k_magnitude", rows.k_magnitude, none);
    section.numbers("dof", rows.dof_magnitude, none + " Or infinite.");
    section.set("u_contains_step", measured && rows.isComplete() && response.unit != "1");
    section.number("u_common_relative", rows.u_common_relative, none);
    section.numbers("u_phase_rad", rows.u_phase_rad, none);
    section.numbers("k_phase", rows.k_phase, none);
    section.set("covariance_re_im", rowsOf(rows.covarianceReIm));
    section.set("covariance_re_im_reason",
        "var Re, covariance, var Im of what is the row's own, without u_common_relative; null where withheld.");
    const std::string noModel = ofRows
        ? "The model was not refined, or the uncertainty of the step is not known."
        : whyMissing;
    section.numbers("u_model_magnitude", rows.u_modelMagnitude, noModel);
    section.numbers("u_model_phase_rad", rows.u_modelPhase_rad, noModel);
    section.numbers("e_n", rows.e_n, noModel + " Or the measured value is withheld.");
}

void addCharacteristics(JsonRecord &root, const ResultsContext &context)
{
    const UncertaintyReport *report = context.results().uncertainty.get();
    if (!report) {
        root.missing("characteristics", context.whyMissing());
        return;
    }
    UncertaintyJson list = UncertaintyJson::array();
    for (const ReportedValue &one : report->ofModel)
        list.push_back(characteristicJson(one));
    root.set("characteristics", std::move(list));
}

void addBudget(JsonRecord &root, const ResultsContext &context)
{
    const UncertaintyReport *report = context.results().uncertainty.get();
    if (!report) {
        root.missing("budget", context.whyMissing());
    } else {
        UncertaintyJson list = UncertaintyJson::array();
        for (const auto &[key, value] : reportedByKey(context.results()))
            addLines(key, *value, list);
        const ResponseResult *response = context.results().response.get();
        const bool isShort = response && response->frequency_Hz.size() <= kMostBudgetRows;
        if (isShort) {
            addResponseLines("response", *response, *report, list);
            addComparisonLines(context.results(), list);
        }
        root.set("budget", std::move(list));
        root.set("budget_reason",
            isShort
                ? "Every reported value has its lines."
                : "The lines of the single frequencies are left out, because there are more than 200.");
    }
}

} // namespace dyncal
