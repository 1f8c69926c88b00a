// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_transducer_json.h"

#include "core/results/results_response_json.h"

namespace dyncal {
namespace {

void addAgainstStep(JsonRecord &section, const ComparisonResult &comparison)
{
    const char *none
        = "The step, or one of the two responses, has no complete uncertainty to compare by.";
    const auto &against = comparison.againstStep;
    section.number("difference_relative",
        against ? std::optional(against->difference_relative) : std::nullopt, none);
    section.number(
        "u_difference_relative", against ? std::optional(against->u_relative) : std::nullopt, none);
    section.number("e_n_mean", against ? std::optional(against->meanE_n()) : std::nullopt, none);
    section.numbers("e_n_step", against ? against->e_n : Eigen::VectorXd(),
        against ? "Withheld in one of the two, or not asked for in the other." : none);
}

} // namespace

void addTransducerComparison(JsonRecord &root, const ResultsContext &context)
{
    const ComparisonResult *comparison = context.results().comparison.get();
    if (!comparison || !comparison->byTransducer) {
        root.missing("comparison",
            comparison ? "No comparison was asked for: comparison.enabled is false."
                       : context.whyMissing());
        return;
    }
    const UncertainResponse &answer = *comparison->byTransducer;
    JsonRecord section = responseSection(answer.response, &answer.report, {});
    section.set("channel", comparison->channel);
    section.text(
        "source_sha256", comparison->sourceSha256, "The reference is a model of the recipe.");
    section.text("certificate", comparison->certificate, "The source states none.");
    section.text("due", comparison->due, "The source states none.");
    addAgainstStep(section, *comparison);
    root.set("comparison", section.take());
}

void addChain(JsonRecord &root, const ResultsContext &context)
{
    const ReferenceStageResult *reference = context.results().reference.get();
    if (!reference || !reference->chain) {
        root.missing("chain",
            reference ? "No response of the chain is stated (chain.source)."
                      : context.whyMissing());
        return;
    }
    JsonRecord section;
    section.set("source_sha256", reference->chain->sourceSha256);
    section.text("certificate", reference->chain->certificate, "The source states none.");
    root.set("chain", section.take());
}

} // namespace dyncal
