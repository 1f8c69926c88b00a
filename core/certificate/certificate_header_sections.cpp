// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_header_sections.h"

#include "core/base/calendar_date.h"
#include "core/base/version.h"
#include "core/capture/sensor_card.h"
#include "core/certificate/certificate_checks.h"
#include "core/certificate/certificate_conformity.h"
#include "core/certificate/certificate_words.h"
#include "core/pipeline/stage_table.h"

#include <map>
#include <vector>

namespace dyncal {

namespace {

/// A typed field; `required` ones are missing when empty (ISO/IEC 17025, 7.8.2.1).
CertificateField typedField(const Recipe &recipe, const char *id, Message label, bool required)
{
    const auto typed = recipe.certificate.fields.find(id);
    if (typed != recipe.certificate.fields.end() && !isBlank(typed->second))
        return {id, std::move(label), verbatim(typed->second), false};
    if (required)
        return {id, std::move(label), {DYNCAL_TEXT("core", "to be filled in"), {}}, true};
    return {id, std::move(label), dash(), false};
}

/// A typed day, missing while it is none: nobody can tell what "31/12" or "banana" means.
CertificateField dateField(const Recipe &recipe, const char *id, Message label)
{
    CertificateField field = typedField(recipe, id, std::move(label), true);
    if (field.missing || isCalendarDate(recipe.certificate.fields.at(id)))
        return field;
    field.value = {DYNCAL_TEXT("core", "%V1 (not a date; write it as 2026-01-31)"),
        {recipe.certificate.fields.at(id)}};
    field.missing = true;
    field.wrong = true;
    return field;
}

/// What the captures know of the sensor under test, by attribute name.
std::string cardEntry(const CalibrationResults &results, const std::string &attribute)
{
    if (!results.captures)
        return {};
    const CaptureSet &captures = results.captures->set;
    for (const Shot &shot : captures.shots) {
        const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
        const Attributes card = dut ? cardOf(captures, *dut) : Attributes();
        const auto entry = card.find(attribute);
        if (entry != card.end() && !isBlank(entry->second))
            return entry->second;
    }
    return {};
}

/// Typed, else from the sensor's card in the capture, else missing.
CertificateField itemField(const CalibrationResults &results, const Recipe &recipe, const char *id,
    const std::string &attribute, Message label)
{
    CertificateField field = typedField(recipe, id, std::move(label), true);
    if (const std::string known = cardEntry(results, attribute); field.missing && !known.empty()) {
        field.value = verbatim(known);
        field.missing = false;
    }
    return field;
}

void addExclusions(const CalibrationResults &results, CertificateSection &section)
{
    if (!results.captures)
        return;
    const std::vector<Shot> &shots = results.captures->set.shots;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const Shot &shot = shots[i];
        if (!shot.included)
            section.paragraphs.push_back({DYNCAL_TEXT("core", "Shot %1 was excluded. Reason: %V2."),
                {std::to_string(i + 1),
                    isBlank(shot.excludeReason) ? english(dash()) : shot.excludeReason}});
    }
}

} // namespace

CertificateSection administrativeSection(const Recipe &recipe)
{
    CertificateSection section;
    section.id = "administrative";
    section.title = {DYNCAL_TEXT("core", "Laboratory and customer"), {}};
    section.fields = {
        typedField(
            recipe, "certificate_number", {DYNCAL_TEXT("core", "Certificate number"), {}}, true),
        typedField(recipe, "laboratory", {DYNCAL_TEXT("core", "Laboratory"), {}}, true),
        typedField(recipe, "laboratory_address",
            {DYNCAL_TEXT("core", "Address of the laboratory"), {}}, true),
        typedField(recipe, "place", {DYNCAL_TEXT("core", "Place of calibration"), {}}, true),
        typedField(recipe, "customer", {DYNCAL_TEXT("core", "Customer"), {}}, true),
        typedField(
            recipe, "customer_address", {DYNCAL_TEXT("core", "Address of the customer"), {}}, true),
        dateField(recipe, "date_received", {DYNCAL_TEXT("core", "Date of receipt"), {}}),
        dateField(recipe, "date_performed", {DYNCAL_TEXT("core", "Date of calibration"), {}}),
        dateField(recipe, "date_issued", {DYNCAL_TEXT("core", "Date of issue"), {}}),
        typedField(recipe, "operator", {DYNCAL_TEXT("core", "Calibrated by"), {}}, true),
    };
    CertificateField approval
        = typedField(recipe, "approved_by", {DYNCAL_TEXT("core", "Approved by"), {}}, false);
    const auto approved = recipe.certificate.fields.find("approved_by");
    if (approved == recipe.certificate.fields.end() || isBlank(approved->second))
        approval.value = {DYNCAL_TEXT("core", "not yet approved"), {}};
    section.fields.push_back(std::move(approval));
    return section;
}

CertificateSection itemSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "item";
    section.title = {DYNCAL_TEXT("core", "Item calibrated"), {}};
    section.fields = {
        itemField(results, recipe, "sensor_manufacturer", "manufacturer",
            {DYNCAL_TEXT("core", "Manufacturer"), {}}),
        itemField(results, recipe, "sensor_model", "model", {DYNCAL_TEXT("core", "Model"), {}}),
        itemField(
            results, recipe, "sensor_serial", "serial", {DYNCAL_TEXT("core", "Serial number"), {}}),
        typedField(recipe, "sensor_description",
            {DYNCAL_TEXT("core", "Description and condition"), {}}, true),
    };
    return section;
}

CertificateSection remarksSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "remarks";
    section.title = {DYNCAL_TEXT("core", "Remarks"), {}};
    const std::map<std::string, std::string> &fields = recipe.certificate.fields;
    if (const auto remarks = fields.find("remarks");
        remarks != fields.end() && !isBlank(remarks->second))
        section.paragraphs.push_back(verbatim(remarks->second));
    addExclusions(results, section);

    CertificateTable table;
    table.id = "findings";
    table.caption = {DYNCAL_TEXT("core", "Findings on the quality of the data"), {}};
    table.columns = {{{DYNCAL_TEXT("core", "Finding"), {}}, false},
        {{DYNCAL_TEXT("core", "Shot"), {}}, true}, {{DYNCAL_TEXT("core", "Severity"), {}}, false},
        {{DYNCAL_TEXT("core", "What was found"), {}}, false},
        {{DYNCAL_TEXT("core", "Accepted because"), {}}, false}};
    for (const Finding &finding : allFindings(results)) {
        if (finding.severity == Severity::Info)
            continue;
        Message reason = dash();
        for (const Acknowledgement &seen : recipe.acknowledge)
            if (seen.finding == finding.id && (seen.shot == 0 || seen.shot == finding.shot))
                reason = verbatim(seen.reason);
        const Message severity = finding.severity == Severity::Block
            ? Message{DYNCAL_TEXT("core", "blocking"), {}}
            : Message{DYNCAL_TEXT("core", "caution"), {}};
        table.rows.push_back({verbatim(finding.id),
            finding.shot > 0 ? inNumbers(std::to_string(finding.shot)) : dash(), severity,
            finding.message, reason});
    }
    if (!table.rows.empty())
        section.tables.push_back(std::move(table));
    addCheckTable(results, section);
    return section;
}

CertificateSection recordsSection(const CalibrationResults &results, const std::string &createdUtc)
{
    CertificateSection section;
    section.id = "records";
    section.title = {DYNCAL_TEXT("core", "Records and software"), {}};
    section.fields
        = {{"software", {DYNCAL_TEXT("core", "Software"), {}},
               {DYNCAL_TEXT("core", "Dyncal %V1, build %V2"), {versionText(), buildText()}}, false},
            {"created", {DYNCAL_TEXT("core", "Computed"), {}}, verbatim(createdUtc), false}};
    CertificateTable table;
    table.id = "inputs";
    table.caption = {DYNCAL_TEXT("core", "Recordings evaluated"), {}};
    table.columns
        = {{{DYNCAL_TEXT("core", "File"), {}}, false}, {{DYNCAL_TEXT("core", "Format"), {}}, false},
            {{DYNCAL_TEXT("core", "SHA-256 of the file"), {}}, false}};
    if (results.captures)
        for (const InputFile &input : results.captures->set.inputs)
            table.rows.push_back(
                {verbatim(input.file), verbatim(input.format), verbatim(input.sha256)});
    if (!table.rows.empty())
        section.tables.push_back(std::move(table));
    return section;
}

CertificateSection statementsSection(const CalibrationResults &results, const Recipe &recipe)
{
    CertificateSection section;
    section.id = "statements";
    section.title = {DYNCAL_TEXT("core", "Statements"), {}};
    section.paragraphs = {
        {DYNCAL_TEXT("core", "The results relate only to the item calibrated."), {}},
        {DYNCAL_TEXT("core",
             "This document shall not be reproduced except in full without the written approval of the laboratory."),
            {}},
        conformityStatement(results, recipe),
        {DYNCAL_TEXT("core",
             "The software does not know how the measuring equipment is traceable; this draft makes no statement of metrological traceability."),
            {}}};
    return section;
}

} // namespace dyncal
