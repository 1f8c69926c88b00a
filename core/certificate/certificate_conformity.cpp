// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_conformity.h"

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/certificate/conformity.h"

namespace dyncal {
namespace {

Message claimText(const DecisionSettings &decision)
{
    return {
        DYNCAL_TEXT("core",
            "the magnitude of the response lies within \xC2\xB1%1 % of its value at low frequency, from %2 to %3"),
        {numberText(decision.within_percent, kDigitsOfSettings),
            settingText(decision.from_Hz, "Hz"), settingText(decision.to_Hz, "Hz")}};
}

Message ruleText(const DecisionSettings &decision)
{
    switch (decision.rule) {
    case DecisionRule::Simple:
        return {
            DYNCAL_TEXT("core",
                "simple acceptance (ILAC-G8): the deviation is at most the limit; a deviation at the limit lies beyond it with a probability of up to 50 %"),
            {}};
    case DecisionRule::GuardBand:
        return {
            DYNCAL_TEXT("core",
                "guard band w = U (ILAC-G8): the deviation is at most the limit less its expanded uncertainty U"),
            {}};
    case DecisionRule::Risk:
        break;
    }
    return {
        DYNCAL_TEXT("core",
            "specific risk (JCGM 106): the probability that the deviation lies beyond the limit is at most %1 % at every frequency"),
        {numberText(decision.maxRisk_percent, kDigitsOfSettings)}};
}

Message verdictText(const ConformityResult &judged)
{
    switch (judged.verdict) {
    case ConformityVerdict::Conforms:
        return {DYNCAL_TEXT("core", "conforms"), {}};
    case ConformityVerdict::DoesNotConform:
        return {DYNCAL_TEXT("core", "does not conform"), {}};
    case ConformityVerdict::NoStatement:
        break;
    }
    return judged.why;
}

/// In percent; one that nobody could tell from none has no digits.
std::string riskText(double risk)
{
    constexpr double kLeast_percent = 0.001;
    const double percent = 100.0 * risk;
    return percent < kLeast_percent ? "< " + numberText(kLeast_percent, 1) : numberText(percent, 2);
}

Message worstText(const JudgedRow &row)
{
    return {DYNCAL_TEXT("core",
                "at %1 the deviation is %2; it lies beyond the limit with a probability of %3 %"),
        {settingText(row.frequency_Hz, "Hz"),
            english(printedWithUncertainty(100.0 * row.deviation, 100.0 * row.u, "%", row.k)),
            riskText(row.risk)}};
}

ConformityResult judged(const CalibrationResults &results, const DecisionSettings &decision)
{
    return judgeConformity(results.response ? *results.response : ResponseResult(), decision);
}

} // namespace

std::optional<CertificateSection> conformitySection(
    const CalibrationResults &results, const Recipe &recipe)
{
    if (!recipe.certificate.decision)
        return std::nullopt;
    const DecisionSettings &decision = *recipe.certificate.decision;
    const ConformityResult result = judged(results, decision);
    CertificateSection section;
    section.id = "conformity";
    section.title = {DYNCAL_TEXT("core", "Statement of conformity"), {}};
    section.fields = {{"claim", {DYNCAL_TEXT("core", "Claim"), {}}, claimText(decision)},
        {"rule", {DYNCAL_TEXT("core", "Decision rule"), {}}, ruleText(decision)},
        {"verdict", {DYNCAL_TEXT("core", "Result"), {}}, verdictText(result)}};
    if (!result.worst)
        return section;
    section.fields.push_back({"worst", {DYNCAL_TEXT("core", "Least favourable frequency"), {}},
        worstText(*result.worst)});
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "Judged at %1 frequencies, no two neighbours farther apart than a third of an octave. The deviation is that of the response, as measured without a model, from its value at the onset of the step: what both share, as the pressure step and the gain of the chain, cancels in it and is not part of its uncertainty."),
            {std::to_string(result.rows)}});
    return section;
}

Message conformityStatement(const CalibrationResults &results, const Recipe &recipe)
{
    if (!recipe.certificate.decision)
        return {DYNCAL_TEXT("core", "No statement of conformity is made."), {}};
    if (judged(results, *recipe.certificate.decision).verdict == ConformityVerdict::NoStatement)
        return {
            DYNCAL_TEXT("core",
                "No statement of conformity could be made; the section of that name has the reason."),
            {}};
    return {DYNCAL_TEXT("core", "A statement of conformity is made in a section of its own."), {}};
}

} // namespace dyncal
