// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_document.h"

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_administration.h"
#include "core/dcc/dcc_budget.h"
#include "core/dcc/dcc_exact.h"
#include "core/dcc/dcc_fields.h"
#include "core/dcc/dcc_measurement.h"
#include "core/dcc/dcc_ref_types.h"
#include "core/dcc/dcc_reported.h"
#include "core/dcc/dcc_row_budget.h"
#include "core/dcc/dcc_sections.h"
#include "core/dcc/dcc_statements.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

/// Sections that are no results: they stand in the administrative data, methods and conditions.
constexpr std::array<std::string_view, 6> kElsewhere{
    "administrative", "item", "method", "statements", "conformity", "issue"};

/// Only figures: a DCC has their numbers.
constexpr std::string_view kFigures = "figures";

/// Of the conditions the fields are influence conditions; the steps are results.
CertificateSection withoutFields(CertificateSection section)
{
    section.fields.clear();
    return section;
}

bool isResult(const CertificateSection &section)
{
    if (std::ranges::find(kElsewhere, section.id) != kElsewhere.end() || section.id == kFigures)
        return false;
    return section.id != "conditions" || !section.tables.empty() || !section.notes.empty();
}

bool hasId(const XmlElement &element)
{
    return std::ranges::any_of(element.attributes, [](const auto &attribute) {
        return attribute == std::pair<std::string, std::string>("id", kDccResponse);
    }) || std::ranges::any_of(element.children, hasId);
}

/// The printed frequency response refers to the one that is not rounded.
void refer(XmlElement &element)
{
    const bool isPrinted = element.name == "dcc:list" && !element.attributes.empty()
        && element.attributes.front().second == refTypeOf("frequency-response");
    if (isPrinted)
        element.attributes.emplace_back("refId", kDccResponse);
    std::ranges::for_each(element.children, refer);
}

XmlElement results(const DccSource &source)
{
    XmlElement list{"dcc:results"};
    for (const CertificateSection &section : source.certificate.sections)
        if (isResult(section))
            list.add(section.id == "key-results" ? dccKeyResults(source.words, section)
                    : section.id == "conditions" ? dccResultOf(source.words, withoutFields(section))
                                                 : dccResultOf(source.words, section));
    std::vector<XmlElement> exact = dccExactResults(source);
    if (std::ranges::any_of(exact, hasId))
        refer(list);
    const auto addAll = [&list](std::vector<XmlElement> more) {
        for (XmlElement &result : more)
            list.add(std::move(result));
    };
    addAll(dccReportedValues(source));
    addAll(std::move(exact));
    addAll(dccBudgets(source));
    addAll(dccRowBudgets(source));
    addAll(dccDrawnValues(source));
    return list;
}

XmlElement measurementResult(const DccSource &source)
{
    XmlElement result{
        "dcc:measurementResult", {{"refId", kDccItem}, {"refType", "dyncal_dynamicCalibration"}}};
    result.add(source.words.element("dcc:name", {source.certificate.title}));
    result.add(dccMethods(source));
    result.add(dccUsedSoftware(source));
    if (XmlElement equipment = dccEquipment(source); !equipment.name.empty())
        result.add(std::move(equipment));
    result.add(dccConditions(source));
    result.add(results(source));
    return result;
}

/// The refTypes of ours that are used, as they stand in the attributes.
void collect(const XmlElement &element, std::set<std::string> &used)
{
    for (const auto &[name, value] : element.attributes) {
        std::string_view left = value;
        while (name == "refType" && !left.empty()) {
            const std::size_t end = std::min(left.find(' '), left.size());
            used.emplace(left.substr(0, end));
            left.remove_prefix(std::min(end + 1, left.size()));
        }
    }
    for (const XmlElement &child : element.children)
        collect(child, used);
}

/// Declares those that are used, in the table's order.
XmlElement definitions(const std::set<std::string> &used)
{
    constexpr const char *kNamespace = "dyncal";
    XmlElement list{"dcc:refTypeDefinitions"};
    for (const DccRefType &known : dccRefTypes()) {
        if (!used.contains(known.refType))
            continue;
        const auto text = [](const char *element, const char *content) {
            return XmlElement{element, {}, {}, {{"dcc:content", {}, content}}};
        };
        list.add({"dcc:refTypeDefinition", {}, {},
            {text("dcc:name", known.refType), text("dcc:description", known.meaning),
                {"dcc:namespace", {}, kNamespace}, {"dcc:link", {}, "urn:dyncal:ref-types:1"},
                {"dcc:release", {}, "v1.0.0"}, {"dcc:value", {}, known.refType}}});
    }
    return list;
}

} // namespace

std::string dccText(const DccSource &source)
{
    XmlElement administration = dccAdministration(source);
    XmlElement measurements{"dcc:measurementResults", {}, {}, {measurementResult(source)}};
    std::set<std::string> used;
    collect(administration, used);
    collect(measurements, used);
    administration.children.insert(administration.children.begin() + 1, definitions(used));
    XmlElement root{"dcc:digitalCalibrationCertificate",
        {{"schemaVersion", "3.3.0"}, {"xmlns:dcc", "https://ptb.de/dcc"},
            {"xmlns:si", "https://ptb.de/si"},
            {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
            {"xsi:schemaLocation", "https://ptb.de/dcc https://ptb.de/dcc/v3.3.0/dcc.xsd"}}};
    root.add(std::move(administration));
    root.add(std::move(measurements));
    return xmlText(root);
}

std::string dccText(const CertificateData &certificate, const CalibrationResults &results,
    const Recipe &recipe, const std::optional<CertificateIssue> &issue,
    const DccTranslation &translate)
{
    DccWords words{{certificate.language}, translate};
    if (!certificate.secondLanguage.empty())
        words.languages.push_back(certificate.secondLanguage);
    return dccText(DccSource{certificate, results, recipe, issue, words});
}

} // namespace dyncal
