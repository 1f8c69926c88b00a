// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/issue/issue_obstacles.h"

#include "core/base/ascii_text.h"
#include "core/certificate/certificate_words.h"
#include "core/certificate/required_fields.h"
#include "core/pipeline/calibration_kind.h"
#include "core/pipeline/stage_table.h"
#include "core/project/laboratory_profile.h"
#include "core/results/publication.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace dyncal {
namespace {

using Names = std::vector<std::string>;

void block(Findings &findings, const char *id, Message message)
{
    findings.push_back({.id = id, .severity = Severity::Block, .message = std::move(message)});
}

bool isReference(const CertificateField &field)
{
    return field.id.starts_with("reference_");
}

/// Fields that are empty or wrong, and references that ended before the measurement.
void addFields(const std::vector<CertificateField> &unfilled, Findings &findings)
{
    Names empty, ended;
    for (const CertificateField &field : unfilled)
        (isReference(field) ? ended : empty)
            .push_back(english(isReference(field) ? field.value : field.label));
    if (!empty.empty())
        block(findings, "CER-001",
            {DYNCAL_TEXT("core",
                 "%1 required fields are empty or wrong: %2; fill them in (certificate.fields of the recipe)."),
                {std::to_string(empty.size()), commaList(empty)}});
    if (!ended.empty())
        block(findings, "CER-003",
            {DYNCAL_TEXT("core",
                 "The certificate of a reference ended before the measurement (%1); state the certificate that held then."),
                {commaList(ended)}});
}

bool isAccepted(const Finding &finding, const Recipe &recipe)
{
    return std::ranges::any_of(recipe.acknowledge, [&](const Acknowledgement &seen) {
        return seen.finding == finding.id && (seen.shot == 0 || seen.shot == finding.shot)
            && !isBlank(seen.reason);
    });
}

void addCautions(const Findings &found, const Recipe &recipe, Findings &findings)
{
    Names open;
    for (const Finding &finding : found)
        if (finding.severity == Severity::Caution && !isAccepted(finding, recipe))
            open.push_back(finding.shot > 0 ? finding.id + " (" + std::to_string(finding.shot) + ")"
                                            : finding.id);
    if (!open.empty())
        block(findings, "CER-002",
            {DYNCAL_TEXT("core",
                 "%1 cautions need a reason before the certificate is issued: %2; look at each and say why it is accepted (acknowledge)."),
                {std::to_string(open.size()), commaList(open)}});
}

void addSecondName(const Recipe &recipe, const IssueNames &names, Findings &findings)
{
    const bool isOther = !isBlank(names.reviewedBy) && names.reviewedBy != issuerOf(recipe, names);
    if (!isOther && recipe.profile && demandsSecondName(*recipe.profile))
        block(findings, "CER-005",
            {DYNCAL_TEXT("core",
                 "The profile %1 demands a second person, and the review is by \"%2\", the issue by \"%3\"; name another one (--reviewed-by)."),
                {recipe.profile->name, names.reviewedBy, issuerOf(recipe, names)}});
}

bool lacksUncertainty(const ReportedValue &reported)
{
    return std::isfinite(reported.value) && !reported.u;
}

/// Rows of S(f) with a value and without its u.
Index rowsWithout(const ResponseResult &response, const RowUncertainty &rows)
{
    Index count = 0;
    for (Index row = 0; row < response.magnitude.size(); ++row)
        if (std::isfinite(response.magnitude[row])
            && !std::isfinite(valueAt(rows.u_magnitude, row)))
            ++count;
    return count;
}

/// What every certificate states: the sensitivity, f0 and damping of an oscillating sensor, S(f).
void addIncomplete(const CalibrationResults &results, Findings &findings)
{
    if (!results.uncertainty)
        return block(findings, "CER-008",
            {DYNCAL_TEXT("core",
                 "No uncertainty was computed, so there is nothing to state; run the job to its end."),
                {}});
    const UncertaintyReport &report = *results.uncertainty;
    Names lacking;
    if (report.sensitivity && lacksUncertainty(*report.sensitivity))
        lacking.push_back(report.sensitivity->of);
    for (const char *of : {"f0_hz", "damping_ratio"})
        if (const ReportedValue *reported = report.find(of);
            reported && lacksUncertainty(*reported))
            lacking.emplace_back(of);
    if (const Index rows = results.response ? rowsWithout(*results.response, report.rows) : 0)
        lacking.push_back("S(f): " + std::to_string(rows));
    if (!lacking.empty())
        block(findings, "CER-008",
            {DYNCAL_TEXT("core",
                 "Reported quantities lack their complete uncertainty: %1; state what the budget of each lacks (docs/method/uncertainty.md)."),
                {commaList(lacking)}});
}

/// The source of a line without the sensor that it is of: "distance_m[Driven side]".
std::string sourceOf(const UncertaintyLine &line)
{
    return line.quantity.substr(0, line.quantity.find('['));
}

/// Inputs that a measuring instrument is behind, which must be traceable.
bool isMeasured(const std::string &quantity)
{
    constexpr std::array<std::string_view, 10> kMeasured{"p1_pa", "t1_k", "velocity_m_s",
        "distance_m", "step_relative", "gain_relative", "clock_relative",
        "reference_sensitivity_relative", "reference_gain_relative", "chain_relative"};
    return std::ranges::find(kMeasured, quantity) != kMeasured.end();
}

/// Named in the file of a transducer or chain, or beside it.
bool isFileCertified(const CalibrationResults &results, const std::string &quantity)
{
    if (!results.reference)
        return false;
    const ReferenceRecords *transducer = results.reference->transducer();
    return (quantity == "reference_sensitivity_relative" && transducer
               && !isBlank(transducer->certificate))
        || (quantity == "chain_relative" && results.reference->chain
            && !isBlank(results.reference->chain->certificate));
}

bool hasCertificate(const Recipe &recipe, const std::string &quantity)
{
    return std::ranges::any_of(recipe.uncertainty.budget, [&](const BudgetEntry &entry) {
        return entry.quantity == quantity && !isBlank(entry.certificate);
    });
}

void addTraceability(const CalibrationResults &results, const Recipe &recipe, Findings &findings)
{
    std::set<std::string> untraced;
    const auto look = [&](const ReportedValue &reported) {
        for (const UncertaintyLine &line : reported.lines)
            if (const std::string source = sourceOf(line); isMeasured(source)
                && !hasCertificate(recipe, source) && !isFileCertified(results, source))
                untraced.insert(source);
    };
    if (results.uncertainty && results.uncertainty->sensitivity)
        look(*results.uncertainty->sensitivity);
    for (const char *of : {"f0_hz", "damping_ratio"})
        if (const ReportedValue *reported
            = results.uncertainty ? results.uncertainty->find(of) : nullptr)
            look(*reported);
    if (!untraced.empty())
        block(findings, "CER-009",
            {DYNCAL_TEXT("core",
                 "No certificate of a reference is named for %1, so the results are not traceable; state it in uncertainty.budget (\"certificate\", \"due\"), of a reference transducer in comparison.certificate, of a chain in chain.certificate."),
                {commaList(Names(untraced.begin(), untraced.end()))}});
}

} // namespace

Findings issueObstacles(
    const PipelineOutcome &outcome, const Recipe &recipe, const IssueNames &names)
{
    if (const std::optional<Error> obstacle = publicationObstacle(outcome))
        return {{.id = obstacle->findingId,
            .severity = Severity::Block,
            .shot = obstacle->shot,
            .message = obstacle->message}};
    Findings findings;
    addFields(unfilledFields(outcome.results, recipe), findings);
    addCautions(allFindings(outcome.results), recipe, findings);
    addSecondName(recipe, names, findings);
    addIncomplete(outcome.results, findings);
    addTraceability(outcome.results, recipe, findings);
    return findings;
}

Finding staleResults()
{
    return {.id = "CER-004",
        .severity = Severity::Block,
        .message
        = {DYNCAL_TEXT("core",
               "The results are not of the recipe and recordings as they are now; wait for them or compute again (F9), then issue."),
            {}}};
}

} // namespace dyncal
