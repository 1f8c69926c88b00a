// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_traceability.h"

#include "core/base/calendar_date.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/pipeline/calibration_kind.h"
#include "core/uncertainty/quantity_words.h"

#include <algorithm>
#include <string>

namespace dyncal {
namespace {

using TraceFields = std::vector<CertificateField>;

void addProfile(const Recipe &recipe, TraceFields &fields)
{
    if (!recipe.profile)
        return;
    const ProfileMark &profile = *recipe.profile;
    fields.push_back({"profile", {DYNCAL_TEXT("core", "Profile of the laboratory"), {}},
        {DYNCAL_TEXT("core", "%V1, version %V2 (SHA-256 %V3)"),
            {profile.name, profile.version, profile.sha256}},
        false});
    std::string changed;
    for (const std::string &key : changedFromProfile(recipe))
        changed += (changed.empty() ? "" : ", ") + key;
    if (!changed.empty())
        fields.push_back(
            {"profile_changed", {DYNCAL_TEXT("core", "Set otherwise than in the profile"), {}},
                verbatim(changed), false});
}

void addChain(const CalibrationResults &results, TraceFields &fields)
{
    if (!results.response || results.response->magnitude.size() == 0)
        return;
    const Message label{DYNCAL_TEXT("core", "Response of amplifier and converter"), {}};
    if (!results.reference || !results.reference->chain) {
        fields.push_back({"chain", label,
            {DYNCAL_TEXT("core",
                 "not divided out: frequency response, poles and what follows from them are of sensor and chain together"),
                {}},
            false});
        return;
    }
    const ChainResponse &chain = *results.reference->chain;
    fields.push_back({"chain", label,
        chain.certificate.empty()
            ? Message{DYNCAL_TEXT("core",
                          "divided out of S(f), file with SHA-256 %1; poles and what follows from them are of sensor and chain together"),
                {chain.sourceSha256}}
            : Message{DYNCAL_TEXT("core",
                          "divided out of S(f), certificate %V1, file with SHA-256 %V2; poles and what follows from them are of sensor and chain together"),
                {chain.certificate, chain.sourceSha256}},
        false});
}

/// The unit that its name ends with; of sensitivity and magnitude that of the response.
std::string unitOf(const CapabilityEntry &entry, const CalibrationResults &results)
{
    if (entry.of == "phase_rad")
        return "rad";
    if (entry.isRelative || entry.of.ends_with("_percent"))
        return "%";
    if (entry.of.ends_with("_hz"))
        return "Hz";
    if (entry.of.ends_with("_s"))
        return "s";
    const bool isOfResponse = entry.of == "sensitivity" || entry.of == "magnitude";
    return isOfResponse && results.response
        ? (results.response->unit == "1" ? "" : results.response->unit)
        : std::string();
}

std::string sizeOf(const CapabilityEntry &entry, const CalibrationResults &results)
{
    const bool isShare = entry.isRelative && entry.of != "phase_rad";
    return settingText(isShare ? 100.0 * entry.expanded : entry.expanded, unitOf(entry, results));
}

Message capabilityText(const CapabilityEntry &entry, const CalibrationResults &results)
{
    const Message of = valueWords(entry.of);
    const std::string size = sizeOf(entry, results), from = settingText(entry.from_Hz, "Hz");
    if (entry.from_Hz == 0.0 && !entry.to_Hz)
        return {"%M1: %L1", {size}, {of}};
    if (!entry.to_Hz)
        return {DYNCAL_TEXT("core", "%M1: %L1 from %L2 on"), {size, from}, {of}};
    const std::string to = settingText(*entry.to_Hz, "Hz");
    if (entry.from_Hz == 0.0)
        return {DYNCAL_TEXT("core", "%M1: %L1 up to %L2"), {size, to}, {of}};
    return {DYNCAL_TEXT("core", "%M1: %L1 from %L2 to %L3"), {size, from, to}, {of}};
}

void addCapability(const CalibrationResults &results, const Recipe &recipe, TraceFields &fields)
{
    for (const CapabilityEntry &entry : recipe.uncertainty.cmc)
        fields.push_back({"cmc",
            {DYNCAL_TEXT("core", "Least U of the laboratory (CMC), below which none is stated"),
                {}},
            capabilityText(entry, results), false});
}

/// The day of the measurement; empty where it is no day.
std::string dayPerformed(const Recipe &recipe)
{
    const auto typed = recipe.certificate.fields.find("date_performed");
    return typed == recipe.certificate.fields.end() ? std::string() : calendarDate(typed->second);
}

std::string numberOf(const BudgetEntry &entry)
{
    return entry.certificate.empty() ? english(dash()) : entry.certificate;
}

Message referenceText(const BudgetEntry &entry, bool isOver)
{
    const Message of = sourceWords(entry.quantity);
    if (entry.due.empty())
        return {DYNCAL_TEXT("core", "%M1: certificate %V1"), {numberOf(entry)}, {of}};
    if (isOver)
        return {
            DYNCAL_TEXT("core", "%M1: certificate %V1, which ended on %2, before the measurement"),
            {numberOf(entry), entry.due}, {of}};
    return {DYNCAL_TEXT("core", "%M1: certificate %V1, valid until %2"),
        {numberOf(entry), entry.due}, {of}};
}

bool isOver(const std::string &due, const std::string &day)
{
    return !due.empty() && !day.empty() && calendarDate(due) < day;
}

CertificateField referenceField(const BudgetEntry &entry, bool isOver)
{
    return {"reference_" + entry.quantity, {DYNCAL_TEXT("core", "Reference standard"), {}},
        referenceText(entry, isOver), isOver, isOver};
}

/// Whether something that is stated without a step depends on it; the references of the step a
/// laboratory has in its profile all the same.
bool isOfModel(const BudgetEntry &entry, const CalibrationResults &results)
{
    if (!results.uncertainty)
        return true;
    const auto hasLine = [&](const ReportedValue &value) {
        return std::ranges::any_of(value.lines,
            [&](const UncertaintyLine &line) { return line.quantity == entry.quantity; });
    };
    return std::ranges::any_of(results.uncertainty->ofModel, hasLine)
        || std::ranges::any_of(results.uncertainty->amplitudes, hasLine);
}

void addBudgetReferences(
    const CalibrationResults &results, const Recipe &recipe, TraceFields &fields)
{
    const std::string day = dayPerformed(recipe);
    const CalibrationKind kind = calibrationKind(results, recipe);
    const bool hasStep = kind != CalibrationKind::FreeDecay && kind != CalibrationKind::UnknownStep;
    for (const BudgetEntry &entry : recipe.uncertainty.budget) {
        const bool isUsed = hasStep || isOfModel(entry, results);
        if (isUsed && (!entry.certificate.empty() || !entry.due.empty()))
            fields.push_back(referenceField(entry, isOver(entry.due, day)));
    }
}

/// Certificate of the reference transducer, as those of the budget's inputs.
void addTransducer(const CalibrationResults &results, const Recipe &recipe, TraceFields &fields)
{
    const ReferenceRecords *records = results.reference ? results.reference->transducer() : nullptr;
    if (!records || (records->certificate.empty() && records->due.empty()))
        return;
    const BudgetEntry entry{.quantity = "reference_sensitivity_relative",
        .certificate = records->certificate,
        .due = records->due};
    CertificateField field = referenceField(entry, isOver(entry.due, dayPerformed(recipe)));
    field.id = "reference_certificate";
    fields.push_back(std::move(field));
}

} // namespace

std::vector<CertificateField> traceabilityFields(
    const CalibrationResults &results, const Recipe &recipe)
{
    TraceFields fields;
    addProfile(recipe, fields);
    addChain(results, fields);
    addCapability(results, recipe, fields);
    addTransducer(results, recipe, fields);
    addBudgetReferences(results, recipe, fields);
    return fields;
}

} // namespace dyncal
