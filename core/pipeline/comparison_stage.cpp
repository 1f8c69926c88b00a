// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/comparison_stage.h"

#include "core/pipeline/model_stages.h"
#include "core/reference/reference_checks.h"
#include "core/uncertainty/delay_difference.h"

#include <utility>

namespace dyncal {
namespace {

/// The recipe's own response, or the one against the other reference.
Result<UncertainResponse> responseAgainst(
    const std::string &reference, const CalibrationResults &r, const Recipe &recipe)
{
    if (recipe.response.reference == reference)
        return UncertainResponse{*r.response, *r.uncertainty};
    Recipe other = recipe;
    other.response.reference = reference;
    Result<ResponseResult> response = responseStage(r, other, *r.model, *r.shock);
    if (!response)
        return tl::unexpected(response.error());
    UncertaintyReport report = uncertaintyOfResponse(r, other, *response);
    return UncertainResponse{std::move(*response), std::move(report)};
}

} // namespace

Result<ComparisonResult> comparisonStage(const CalibrationResults &results, const Recipe &recipe)
{
    ComparisonResult result;
    const ReferenceRecords *reference = results.reference->transducer();
    if (!reference)
        return result;
    Result<UncertainResponse> byTransducer = responseAgainst("transducer", results, recipe);
    if (!byTransducer)
        return tl::unexpected(byTransducer.error());
    Result<UncertainResponse> byStep = responseAgainst("computed-step", results, recipe);
    if (!byStep)
        return tl::unexpected(byStep.error());
    result.channel = reference->channel;
    result.sourceSha256 = reference->sourceSha256;
    result.certificate = reference->certificate;
    result.due = reference->due;
    result.againstStep = compareWithStep(*byTransducer, *byStep, reference->correlationWithStep);
    result.findings = judgeReferenceRecords(*reference, recipe.checks);
    if (recipe.response.isByTransducer()) {
        const Findings ofLevel = judgeLevelOfReference(*reference);
        result.findings.insert(result.findings.end(), ofLevel.begin(), ofLevel.end());
    }
    if (result.againstStep) {
        const Findings against = judgeAgainstStep(*result.againstStep);
        result.findings.insert(result.findings.end(), against.begin(), against.end());
    }
    if (const auto delay = delayDifference(*byTransducer)) {
        const Findings late = judgeDelay(*delay, reference->delay_s);
        result.findings.insert(result.findings.end(), late.begin(), late.end());
    }
    result.byTransducer = std::move(*byTransducer);
    result.byStep = std::move(*byStep);
    return result;
}

} // namespace dyncal
