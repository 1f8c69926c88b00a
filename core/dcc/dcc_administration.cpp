// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_administration.h"

#include "core/base/calendar_date.h"
#include "core/base/version.h"
#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_country.h"
#include "core/dcc/dcc_statements.h"

#include <array>
#include <utility>

namespace dyncal {
namespace {

constexpr const char *kNotStated = "\xE2\x80\x93";

std::string orNotStated(std::string text)
{
    return text.empty() ? kNotStated : text;
}

XmlElement software(const DccSource &source)
{
    return {"dcc:dccSoftware", {}, {}, {dccSoftware(source)}};
}

/// A day that is typed, else that of the computation: a DCC cannot do without.
std::string day(const DccSource &source, const char *field)
{
    constexpr std::size_t kDay = 10;
    const std::string typed = calendarDate(source.typed("administrative", field));
    return typed.empty() ? source.certificate.createdUtc.substr(0, kDay) : typed;
}

/// The DCC has five words for a place; the place itself is a statement.
std::string performanceLocation(const DccSource &source)
{
    const std::string place = source.typed("administrative", "place");
    const auto isOf = [&](const char *whose) {
        return !place.empty()
            && (place == source.typed("administrative", whose)
                || place == source.typed("administrative", std::string(whose).append("_address")));
    };
    return isOf("laboratory") ? "laboratory" : isOf("customer") ? "customer" : "other";
}

XmlElement replaced(const DccSource &source)
{
    return {"dcc:reportAmendedSubstituted", {}, {},
        {{"dcc:typeOfChange", {}, "amended"},
            {"dcc:replacedUniqueIdentifier", {}, inOneLine(source.issue->amends)}}};
}

XmlElement coreData(const DccSource &source)
{
    XmlElement core{"dcc:coreData"};
    const auto add = [&](const char *name, std::string text) {
        core.add({std::string("dcc:").append(name), {}, std::move(text)});
    };
    add("countryCodeISO3166_1", dccCountry(source.recipe, "laboratory"));
    for (const std::string &language : source.words.languages)
        add("usedLangCodeISO639_1", language);
    add("mandatoryLangCodeISO639_1", source.words.languages.front());
    add("uniqueIdentifier",
        source.issue ? orNotStated(inOneLine(source.issue->number)) : kDccDraft);
    if (!calendarDate(source.typed("administrative", "date_received")).empty())
        add("receiptDate", day(source, "date_received"));
    add("beginPerformanceDate", day(source, "date_performed"));
    add("endPerformanceDate", day(source, "date_performed"));
    add("performanceLocation", performanceLocation(source));
    if (!calendarDate(source.typed("administrative", "date_issued")).empty())
        add("issueDate", day(source, "date_issued"));
    if (source.issue && !source.issue->amends.empty())
        core.add(replaced(source));
    return core;
}

XmlElement named(const DccSource &source, const std::string &name)
{
    return source.words.element("dcc:name", {verbatim(orNotStated(name))});
}

/// An address as it was typed: nobody has said what of it is the street.
XmlElement contact(const DccSource &source, const char *element, const std::string &whose)
{
    const std::string address = source.typed("administrative", whose + "_address");
    return {element, {}, {},
        {named(source, source.typed("administrative", whose)),
            {"dcc:location", {}, {},
                {{"dcc:countryCode", {}, dccCountry(source.recipe, whose)},
                    source.words.element("dcc:further", {verbatim(orNotStated(address))})}}}};
}

XmlElement laboratory(const DccSource &source)
{
    return {"dcc:calibrationLaboratory", {}, {}, {contact(source, "dcc:contact", "laboratory")}};
}

XmlElement customer(const DccSource &source)
{
    return contact(source, "dcc:customer", "customer");
}

XmlElement person(const DccSource &source, const std::string &name, const char *role, bool isSigner)
{
    return {"dcc:respPerson", {}, {},
        {{"dcc:person", {}, {}, {named(source, name)}}, {"dcc:role", {}, role},
            {"dcc:mainSigner", {}, isSigner ? "true" : "false"}}};
}

XmlElement persons(const DccSource &source)
{
    const std::string approved = source.typed("administrative", "approved_by");
    XmlElement list{"dcc:respPersons"};
    list.add(person(
        source, source.typed("administrative", "operator"), "calibrated by", approved.empty()));
    if (!approved.empty())
        list.add(person(source, approved, "approved by", true));
    return list;
}

XmlElement identification(const DccSource &source)
{
    const CertificateField *serial = source.field("item", "sensor_serial");
    return {"dcc:identifications", {}, {},
        {{"dcc:identification", {}, {},
            {{"dcc:issuer", {}, "manufacturer"},
                {"dcc:value", {}, orNotStated(source.typed("item", "sensor_serial"))},
                source.words.element("dcc:name", {serial ? serial->label : dash()})}}}};
}

XmlElement items(const DccSource &source)
{
    const auto maker = source.typed("item", "sensor_manufacturer");
    XmlElement item{"dcc:item", {{"id", kDccItem}, {"refType", "dyncal_pressureSensor"}}};
    item.add(
        source.words.element("dcc:name", {Message{DYNCAL_TEXT("core", "Pressure sensor"), {}}}));
    item.add(source.words.element(
        "dcc:description", {verbatim(orNotStated(source.typed("item", "sensor_description")))}));
    item.add({"dcc:manufacturer", {}, {}, {named(source, maker)}});
    item.add({"dcc:model", {}, orNotStated(source.typed("item", "sensor_model"))});
    item.add(identification(source));
    XmlElement list{"dcc:items"};
    list.add(std::move(item));
    return list;
}

} // namespace

XmlElement dccSoftware(const DccSource &source)
{
    return {"dcc:software", {}, {},
        {source.words.element("dcc:name", {verbatim("Dyncal")}),
            {"dcc:release", {}, std::string("v").append(versionText())},
            {"dcc:type", {}, "application"},
            source.words.element("dcc:description",
                {Message{
                    DYNCAL_TEXT("core", "Dyncal %V1, build %V2"), {versionText(), buildText()}}})}};
}

XmlElement dccAdministration(const DccSource &source)
{
    constexpr std::array kParts{
        software, coreData, items, laboratory, persons, customer, dccStatements};
    XmlElement administration{"dcc:administrativeData"};
    for (const auto part : kParts)
        administration.add(part(source));
    return administration;
}

} // namespace dyncal
