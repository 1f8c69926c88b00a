// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/calibration.h"

#include "app/base/interrupt.h"
#include "app/cli/console.h"

#include "core/base/number_text.h"
#include "core/capture/capture_seal.h"
#include "core/capture/opening/capture_open.h"
#include "core/pipeline/stage_table.h"
#include "core/project/recipe_correction.h"

#include <algorithm>
#include <memory>

namespace dyncal {
namespace {

/// Whether a blocking finding already says what stopped the run.
bool isSaid(const Error &error, const Findings &findings)
{
    return std::any_of(findings.begin(), findings.end(), [&](const Finding &finding) {
        return finding.severity == Severity::Block && finding.id == error.findingId
            && finding.shot == error.shot;
    });
}

} // namespace

std::optional<Index> typedOrder(const std::string &text)
{
    constexpr double kReadable = 1e6;
    const std::optional<double> value = parseNumber(text);
    if (!value || !(*value >= 1.0 && *value <= kReadable))
        return std::nullopt;
    const auto whole = static_cast<Index>(*value);
    return static_cast<double>(whole) == *value ? std::optional(whole) : std::nullopt;
}

Result<Recipe> withOrder(Recipe recipe, const std::string &order)
{
    if (order.empty())
        return recipe;
    recipe.realization.order = {};
    if (order == "auto")
        return recipe;
    const std::optional<Index> value = typedOrder(order);
    if (!value)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "--order is \"%1\"; it needs \"auto\" or a whole number from 1."),
                {order}});
    return correctedRecipe(recipe, {{}, "realization.order", std::to_string(*value)});
}

Result<CaptureSet> readForCalibration(const std::vector<std::string> &files, const Recipe &recipe)
{
    ProgressLine progress("Reading");
    return readCaptures(files, recipe.import, {interruptToken(), progress.sink()});
}

PipelineOutcome ofWholeRecordings(PipelineOutcome outcome, const CaptureSet &set)
{
    if (outcome.error && outcome.error->kind == ErrorKind::Cancelled)
        return outcome;
    Result<void> whole = checkStillWhole(set);
    if (whole)
        return outcome;
    outcome = {};
    outcome.error = std::move(whole.error());
    return outcome;
}

PipelineOutcome calibrate(const CaptureSet &set, const Recipe &recipe, StageId last)
{
    ResultCache cache;
    return calibrate(set, recipe, last, cache);
}

PipelineOutcome calibrate(
    const CaptureSet &set, const Recipe &recipe, StageId last, ResultCache &cache)
{
    ProgressLine progress("Computing");
    return ofWholeRecordings(runPipeline(std::make_shared<CaptureSet>(set), recipe, cache, last,
                                 {interruptToken(), progress.sink()}),
        set);
}

int reportOutcome(const PipelineOutcome &outcome)
{
    const Findings findings = allFindings(outcome.results);
    reportFindings(findings);
    if (!outcome.error)
        return static_cast<int>(exitCodeOf(findings));
    if (!isSaid(*outcome.error, findings))
        report(*outcome.error);
    for (const Error &further : outcome.error->further)
        if (!isSaid(further, findings))
            report(further);
    return static_cast<int>(exitCodeOf(*outcome.error));
}

} // namespace dyncal
