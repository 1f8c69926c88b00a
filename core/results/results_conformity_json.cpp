// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_conformity_json.h"

#include "core/certificate/conformity.h"

#include <cmath>

namespace dyncal {
namespace {

/// Empty where there is no statement.
const char *verdictName(ConformityVerdict verdict)
{
    switch (verdict) {
    case ConformityVerdict::Conforms:
        return "conforms";
    case ConformityVerdict::DoesNotConform:
        return "does-not-conform";
    case ConformityVerdict::NoStatement:
        break;
    }
    return "";
}

JsonRecord worstJson(const JudgedRow &row)
{
    JsonRecord record;
    record.set("frequency_hz", row.frequency_Hz);
    record.set("deviation_percent", 100.0 * row.deviation);
    record.set("u_percent", 100.0 * row.u);
    record.set("k", row.k);
    record.number("dof", row.dof, "Infinite.");
    record.set("risk_percent", 100.0 * row.risk);
    return record;
}

} // namespace

void addConformity(JsonRecord &root, const ResultsContext &context)
{
    const auto &decision = context.recipe.certificate.decision;
    const ResponseResult *response = context.results().response.get();
    if (!decision) {
        root.missing("conformity", "The recipe asks for no statement (certificate.decision).");
        return;
    }
    if (!response) {
        root.missing("conformity", context.whyMissing());
        return;
    }
    const ConformityResult judged = judgeConformity(*response, *decision);
    JsonRecord section;
    section.text("verdict", verdictName(judged.verdict), english(judged.why));
    section.set("rows", judged.rows);
    if (judged.worst)
        section.set("worst", worstJson(*judged.worst).take());
    else
        section.missing("worst", "No frequency was judged.");
    root.set("conformity", section.take());
}

} // namespace dyncal
