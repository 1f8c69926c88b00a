// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_json.h"

#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/pipeline/calibration_kind.h"
#include "core/pipeline/stage_table.h"
#include "core/results/method_versions.h"
#include "core/results/results_analysis_json.h"
#include "core/results/results_checks_json.h"
#include "core/results/results_conformity_json.h"
#include "core/results/results_measurement_json.h"
#include "core/results/results_model_json.h"
#include "core/results/results_monte_carlo_json.h"
#include "core/results/results_reading.h"
#include "core/results/results_response_json.h"
#include "core/results/results_sensitivity_json.h"
#include "core/results/results_shock_json.h"
#include "core/results/results_transducer_json.h"
#include "core/results/results_uncertainty_json.h"

#include <algorithm>

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

Json software()
{
    return {{"name", "dyncal"}, {"version", versionText()}, {"build", buildText()},
        {"method", Json(methodVersions())}};
}

Json findingJson(const Finding &finding)
{
    JsonRecord record;
    record.set("id", finding.id);
    record.set("severity", severityName(finding.severity));
    if (finding.shot > 0)
        record.set("shot", finding.shot);
    else
        record.missing("shot", "Concerns no single shot.");
    record.text("channel", finding.channel, "Concerns no single channel.");
    record.number("time_s", finding.time_s, "Has no place in time.");
    record.set("message", english(finding.message));
    record.number("value", finding.value, "Is not about one number.");
    record.number("limit", finding.limit, "Has no limit.");
    Json causes = Json::array();
    for (const FindingCause cause : finding.causes)
        causes.push_back(findingCauseName(cause));
    record.set("cause", std::move(causes));
    if (finding.correction)
        record.set("mend",
            {{"label", english(finding.correction->label)}, {"key", finding.correction->key},
                {"value", finding.correction->value}});
    return record.take();
}

/// The error that stopped the run, as a finding that blocks.
Finding asFinding(const Error &error)
{
    return {.id = error.findingId,
        .severity = Severity::Block,
        .shot = error.shot,
        .message = error.message};
}

/// Puts what stopped the run among the findings, unless it is of no entry of the catalogue.
void tell(const Error &error, Findings &findings)
{
    if (error.findingId.empty())
        return;
    const Finding gravest = asFinding(error);
    const auto told = std::find_if(findings.begin(), findings.end(),
        [&](const Finding &f) { return f.id == gravest.id && f.shot == gravest.shot; });
    if (told == findings.end()) {
        findings.push_back(gravest);
    } else if (told->severity != gravest.severity) { // what was a caution has stopped the run
        told->severity = gravest.severity;
        told->message = gravest.message;
    }
}

void addError(JsonRecord &root, const PipelineOutcome &outcome)
{
    if (!outcome.error) {
        root.missing("error", "The run came to its end.");
        return;
    }
    JsonRecord record;
    record.set("stage", stageName(outcome.failedStage));
    record.set("message", english(outcome.error->message));
    record.text("finding", outcome.error->findingId, "Is no entry of the findings catalogue.");
    root.set("error", record.take());
}

void addFindings(JsonRecord &root, const ResultsContext &context)
{
    Json list = Json::array();
    for (const Finding &finding : allFindings(context.outcome))
        list.push_back(findingJson(finding));
    root.set("findings", std::move(list));
}

} // namespace

Findings allFindings(const PipelineOutcome &outcome)
{
    Findings findings = allFindings(outcome.results);
    if (!outcome.error)
        return findings;
    tell(*outcome.error, findings);
    for (const Error &further : outcome.error->further)
        tell(further, findings);
    return findings;
}

std::string resultsJson(
    const PipelineOutcome &outcome, const Recipe &recipe, const std::string &createdUtc)
{
    const ResultsContext context{outcome, recipe};
    JsonRecord root;
    root.set("schema", kResultsSchema);
    root.set("software", software());
    root.set("created_utc", createdUtc);
    root.set("recipe", Json::parse(recipeJson(recipe)));
    root.set("kind", calibrationKindName(calibrationKind(context.results(), recipe)));
    addInputs(root, context);
    addShots(root, context);
    addDrift(root, context);
    addEchoes(root, context);
    addSensitivitySummary(root, context);
    addShock(root, context);
    addChecks(root, context);
    addSpectrum(root, context);
    addComponents(root, context);
    addModelInput(root, context);
    addRealization(root, context);
    addModel(root, context);
    addResponse(root, context);
    addTransducerComparison(root, context);
    addChain(root, context);
    addBands(root, context);
    addCharacteristics(root, context);
    addBudget(root, context);
    addChainMonteCarlo(root, context);
    addConformity(root, context);
    addFindings(root, context);
    addError(root, outcome);
    // Names in foreign files need not be UTF-8; results.json always is.
    return jsonText(root.take());
}

} // namespace dyncal
