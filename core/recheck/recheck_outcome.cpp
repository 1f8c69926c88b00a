// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/recheck_outcome.h"

#include "core/base/json_text.h"
#include "core/results/results_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {
namespace {

using AnswerJson = nlohmann::json;

constexpr std::array<const char *, 9> kKindNames{"unreadable", "blocked", "withdrawn",
    "unit-changed", "over-u", "stated-now", "finding-appeared", "finding-gone", "methods"};

std::string softwareText(const AnswerJson &results)
{
    const AnswerJson &software = valueAt(results, "software");
    return textAt(software, "version") + " (build " + textAt(software, "build") + ")";
}

void dropFate(QuantityDifferences &differences, QuantityFate fate)
{
    std::erase_if(differences.list, [fate](const auto &one) { return one.fate == fate; });
}

/// What a run that is blocked no longer says is gone with it, and no news of its own.
void forgetWhatStopped(RecheckedRun &run)
{
    dropFate(run.quantities, QuantityFate::Withdrawn);
    run.findings.gone.clear();
}

RecheckKind kindOf(const QuantityDifference &difference)
{
    switch (difference.fate) {
    case QuantityFate::Withdrawn:
        return RecheckKind::Withdrawn;
    case QuantityFate::UnitChanged:
        return RecheckKind::UnitChanged;
    case QuantityFate::Compared:
        break;
    case QuantityFate::StatedNow:
        return RecheckKind::StatedNow;
    }
    return RecheckKind::OverU;
}

void addQuantities(const RecheckAnswer &answer, std::vector<RecheckRow> &rows)
{
    for (const QuantityDifference &one : answer.run->quantities.list)
        if (one.fate != QuantityFate::Compared || one.isOverU())
            rows.push_back({&answer, kindOf(one), &one});
}

void addTexts(const RecheckAnswer &answer, std::vector<RecheckRow> &rows)
{
    const RecheckedRun &run = *answer.run;
    if (run.isNewlyBlocked())
        rows.push_back({&answer, RecheckKind::Blocked, nullptr, run.blockedNow});
    for (const StatedFinding &one : run.findings.appeared)
        rows.push_back({&answer, RecheckKind::FindingAppeared, nullptr, one.text()});
    for (const StatedFinding &one : run.findings.gone)
        rows.push_back({&answer, RecheckKind::FindingGone, nullptr, one.text()});
    if (!run.methods.empty())
        rows.push_back({&answer, RecheckKind::Methods, nullptr, methodChangesText(run)});
}

double sizeOf(const RecheckRow &row)
{
    return row.kind == RecheckKind::OverU ? row.difference->overU : 0.0;
}

bool isGraver(const RecheckRow &a, const RecheckRow &b)
{
    return a.kind != b.kind ? a.kind < b.kind : sizeOf(a) > sizeOf(b);
}

std::string unrecordedText(const MethodChange &change)
{
    return change.step + " -> " + std::to_string(*change.now);
}

AnswerJson numberOrNull(double value)
{
    return std::isfinite(value) ? AnswerJson(value) : AnswerJson();
}

AnswerJson textOrNull(const std::string &text)
{
    return text.empty() ? AnswerJson() : AnswerJson(text);
}

/// {step: version} of the steps that changed, of one side; null where none are recorded.
AnswerJson versionsJson(const RecheckAnswer &answer, std::optional<int> MethodChange::*side)
{
    const bool isThen = side == &MethodChange::issued;
    if (!answer.run || (isThen && !answer.run->areMethodsRecorded))
        return {};
    AnswerJson versions = AnswerJson::object();
    for (const MethodChange &change : answer.run->methods)
        versions[change.step] = change.*side ? AnswerJson(*(change.*side)) : AnswerJson();
    return versions;
}

AnswerJson quantityJson(const QuantityDifference &difference)
{
    const QuantityPair &pair = difference.pair;
    const bool hasU = std::isfinite(difference.U);
    return {{"of", pair.of}, {"where", textOrNull(pair.where)}, {"unit", textOrNull(pair.unit)},
        {"unit_now", std::isfinite(pair.now) ? textOrNull(pair.unitNow) : AnswerJson()},
        {"issued", numberOrNull(pair.issued)}, {"now", numberOrNull(pair.now)},
        {"u_expanded", numberOrNull(difference.U)},
        {"k", hasU ? AnswerJson(difference.k) : AnswerJson()},
        {"k_assumed", hasU ? AnswerJson(difference.isKAssumed) : AnswerJson()},
        {"u_of_noise_alone", hasU ? AnswerJson(pair.isOfNoiseAlone) : AnswerJson()},
        {"difference_over_u", numberOrNull(difference.overU)}};
}

AnswerJson noQuantityJson()
{
    AnswerJson json;
    for (const char *key : {"of", "where", "unit", "unit_now", "issued", "now", "u_expanded", "k",
             "k_assumed", "u_of_noise_alone", "difference_over_u"})
        json[key] = nullptr;
    return json;
}

AnswerJson recheckRowJson(const RecheckRow &row)
{
    AnswerJson json = row.difference ? quantityJson(*row.difference) : noQuantityJson();
    json["number"] = nullptr;
    json["folder"] = row.answer->folder;
    json["kind"] = recheckKindName(row.kind);
    json["method_issued"] = versionsJson(*row.answer, &MethodChange::issued);
    json["method_now"] = versionsJson(*row.answer, &MethodChange::now);
    json["amendment_needed"] = row.needsAmendment();
    json["message"] = textOrNull(row.message);
    return json;
}

} // namespace

bool RecheckedRun::hasDifferences() const
{
    return isNewlyBlocked()
        || std::ranges::any_of(quantities.list,
            [](const QuantityDifference &one) { return one.isGone() || one.isOverU(); });
}

bool RecheckedRun::isAsIssued() const
{
    return areMethodsRecorded && methods.empty() && blockedThen.empty() && blockedNow.empty()
        && findings.appeared.empty() && findings.gone.empty()
        && std::ranges::all_of(
            quantities.list, [](const QuantityDifference &one) { return one.overU == 0.0; });
}

RecheckedRun recheckedRun(const EarlierRun &run, const nlohmann::json &now,
    const std::string &refusal, RecheckDepth depth)
{
    const auto methods = statedMethods(run.results);
    RecheckedRun rechecked{textAt(run.results, "created_utc"), softwareText(run.results),
        methods.has_value(), methodChanges(methods, methodVersions()), blockOf(run.results),
        refusal.empty() ? blockOf(now) : refusal,
        quantityDifferences(statedQuantities(run.results, now)),
        findingChanges(run.results, now, depth), run.remarks};
    if (!rechecked.blockedNow.empty())
        forgetWhatStopped(rechecked);
    if (!rechecked.blockedThen.empty())
        dropFate(rechecked.quantities, QuantityFate::StatedNow);
    if (!refusal.empty())
        rechecked.findings = {};
    return rechecked;
}

const char *recheckKindName(RecheckKind kind)
{
    return kKindNames[static_cast<std::size_t>(kind)];
}

bool RecheckRow::needsAmendment() const
{
    return answer->run && answer->run->blockedThen.empty()
        && (kind == RecheckKind::Blocked || kind == RecheckKind::Withdrawn
            || kind == RecheckKind::UnitChanged || kind == RecheckKind::OverU);
}

std::vector<RecheckRow> recheckRows(const std::vector<RecheckAnswer> &answers)
{
    std::vector<RecheckRow> rows;
    for (const RecheckAnswer &answer : answers) {
        if (!answer.run) {
            rows.push_back(
                {&answer, RecheckKind::Unreadable, nullptr, english(answer.run.error().message)});
            continue;
        }
        addQuantities(answer, rows);
        addTexts(answer, rows);
    }
    std::ranges::stable_sort(rows, isGraver);
    return rows;
}

std::string recheckJson(const std::vector<RecheckAnswer> &answers)
{
    AnswerJson list = AnswerJson::array();
    for (const RecheckRow &row : recheckRows(answers))
        list.push_back(recheckRowJson(row));
    return jsonText(list);
}

std::string methodChangesText(const RecheckedRun &run)
{
    std::string text;
    for (const MethodChange &change : run.methods)
        text += (text.empty() ? "" : ", ")
            + (run.areMethodsRecorded ? change.text() : unrecordedText(change));
    if (!run.areMethodsRecorded)
        return "made before method versions were recorded; changed since the first: " + text;
    const bool isLater
        = std::ranges::any_of(run.methods, [](const auto &one) { return one.isOfLaterVersion(); });
    return isLater ? text + "; the results were made by a later version of Dyncal" : text;
}

} // namespace dyncal
