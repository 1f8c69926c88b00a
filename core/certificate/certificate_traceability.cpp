// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_traceability.h"

#include "core/base/calendar_date.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"

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
    if (!results.reference || !results.reference->chain || !results.response
        || results.response->magnitude.size() == 0)
        return;
    const ChainResponse &chain = *results.reference->chain;
    const Message label{DYNCAL_TEXT("core", "Response of amplifier and converter"), {}};
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

std::string sizeOf(const CapabilityEntry &entry)
{
    const bool isPhase = entry.of == "phase_rad";
    return entry.isRelative && !isPhase ? numberText(100.0 * entry.expanded, 3) + " %"
                                        : numberText(entry.expanded, 3) + (isPhase ? " rad" : "");
}

std::string bandOf(const CapabilityEntry &entry)
{
    if (entry.from_Hz == 0.0 && !entry.to_Hz)
        return "";
    return " (" + settingText(entry.from_Hz, "Hz") + " ... "
        + (entry.to_Hz ? settingText(*entry.to_Hz, "Hz") : "") + ")";
}

void addCapability(const Recipe &recipe, TraceFields &fields)
{
    std::string list;
    for (const CapabilityEntry &entry : recipe.uncertainty.cmc)
        list += (list.empty() ? "" : ", ") + entry.of + " " + sizeOf(entry) + bandOf(entry);
    if (!list.empty())
        fields.push_back({"cmc",
            {DYNCAL_TEXT("core", "Least U of the laboratory (CMC), below which none is stated"),
                {}},
            inNumbers(list), false});
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
    if (entry.due.empty())
        return {DYNCAL_TEXT("core", "%V1: certificate %V2"), {entry.quantity, numberOf(entry)}};
    if (isOver)
        return {
            DYNCAL_TEXT("core", "%V1: certificate %V2, which ended on %3, before the measurement"),
            {entry.quantity, numberOf(entry), entry.due}};
    return {DYNCAL_TEXT("core", "%V1: certificate %V2, valid until %3"),
        {entry.quantity, numberOf(entry), entry.due}};
}

bool isOver(const BudgetEntry &entry, const std::string &day)
{
    return !entry.due.empty() && !day.empty() && calendarDate(entry.due) < day;
}

CertificateField referenceField(const BudgetEntry &entry, bool isOver)
{
    return {"reference_" + entry.quantity, {DYNCAL_TEXT("core", "Reference of the budget"), {}},
        referenceText(entry, isOver), isOver, isOver};
}

void addBudgetReferences(const Recipe &recipe, TraceFields &fields)
{
    const std::string day = dayPerformed(recipe);
    for (const BudgetEntry &entry : recipe.uncertainty.budget)
        if (!entry.certificate.empty() || !entry.due.empty())
            fields.push_back(referenceField(entry, isOver(entry, day)));
}

} // namespace

std::vector<CertificateField> traceabilityFields(
    const CalibrationResults &results, const Recipe &recipe)
{
    TraceFields fields;
    addProfile(recipe, fields);
    addChain(results, fields);
    addCapability(recipe, fields);
    addBudgetReferences(recipe, fields);
    return fields;
}

} // namespace dyncal
