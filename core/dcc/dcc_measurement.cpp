// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_measurement.h"

#include "core/certificate/certificate_words.h"
#include "core/dcc/dcc_administration.h"
#include "core/dcc/dcc_fields.h"
#include "core/dcc/dcc_quantity.h"
#include "core/results/method_versions.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

constexpr std::string_view kReference = "reference_"; ///< of the budget, by their quantities

XmlElement renamed(const char *name, XmlElement element)
{
    element.name = name;
    return element;
}

XmlElement method(const DccSource &source, const char *refType, const Message &name,
    const std::vector<Message> &description, const char *norm)
{
    XmlElement used = withRefType("dcc:usedMethod", refType);
    used.add(source.words.element("dcc:name", {name}));
    if (!description.empty())
        used.add(source.words.element("dcc:description", description));
    if (norm)
        used.add({"dcc:norm", {}, norm});
    return used;
}

bool isEquipment(const CertificateField &field)
{
    return field.id.starts_with(kReference) || field.id == "chain";
}

XmlElement calibration(const DccSource &source, const CertificateSection &section)
{
    const CertificateField *name = source.field("method", "method_id");
    XmlElement used = method(source, "basic_calibrationMethod", name ? name->value : section.title,
        section.paragraphs, nullptr);
    XmlElement quantities{"dcc:usedMethodQuantities"};
    for (const CertificateField &field : section.fields)
        if (field.id != "method_id" && (!isEquipment(field) || field.id == "chain"))
            quantities.add(renamed("dcc:usedMethodQuantity",
                dccQuantityOf(
                    source.words, field.label, refTypeOf("method." + field.id), field.value)));
    if (!quantities.children.empty())
        used.add(std::move(quantities));
    return used;
}

XmlElement uncertainty(const DccSource &source)
{
    std::vector<Message> said;
    for (const char *id : {"key-results", "results"})
        if (const CertificateSection *section = source.certificate.section(id))
            said.insert(said.end(), section->notes.begin(), section->notes.end());
    return method(source, "basic_uncertainty",
        {DYNCAL_TEXT("core", "Evaluation of the uncertainty"), {}}, said, "JCGM 100:2008");
}

XmlElement versions(const DccSource &source)
{
    XmlElement used = method(source, "dyncal_methodVersions",
        {DYNCAL_TEXT("core", "Versions of the methods, stage by stage"), {}}, {}, nullptr);
    DccColumn stages{{DYNCAL_TEXT("core", "Stage"), {}}, "dyncal_stage"};
    DccColumn numbers{{DYNCAL_TEXT("core", "Version"), {}}, "dyncal_methodVersion"};
    for (const auto &[stage, version] : methodVersions()) {
        stages.words.push_back(verbatim(stage));
        numbers.values.push_back(std::to_string(version));
        numbers.units.push_back("\\one");
    }
    XmlElement columns;
    addDccColumn(source.words, stages, columns);
    addDccColumn(source.words, numbers, columns);
    XmlElement &quantities = used.add({"dcc:usedMethodQuantities"});
    for (XmlElement &quantity : columns.children)
        quantities.add(renamed("dcc:usedMethodQuantity", std::move(quantity)));
    return used;
}

/// What a certificate is known by: its number, and the hash of its file where there is one.
XmlElement certificateOf(
    const DccSource &source, const std::string &number, const std::string &sha256)
{
    return {"dcc:certificate", {}, {},
        {source.words.element(
             "dcc:referral", {Message{DYNCAL_TEXT("core", "Calibration certificate"), {}}}),
            {"dcc:referralID", {}, number}, {"dcc:procedure", {}, "SHA-256"},
            {"dcc:value", {}, sha256}}};
}

XmlElement identificationOf(const DccSource &source, const std::string &number)
{
    return {"dcc:identifications", {}, {},
        {{"dcc:identification", {}, {},
            {{"dcc:issuer", {}, "other"}, {"dcc:value", {}, number},
                source.words.element(
                    "dcc:name", {Message{DYNCAL_TEXT("core", "Calibration certificate"), {}}})}}}};
}

XmlElement equipment(const DccSource &source, const Message &name, const Message &description,
    const std::string &number, const std::string &sha256)
{
    XmlElement one{
        "dcc:measuringEquipment", {{"refType", "basic_measurementStandard dyncal_reference"}}};
    one.add(source.words.element("dcc:name", {name}));
    one.add(source.words.element("dcc:description", {description}));
    const std::string known = inOneLine(number);
    if (!known.empty() && !sha256.empty())
        one.add(certificateOf(source, known, sha256));
    else if (!known.empty())
        one.add(identificationOf(source, known));
    return one;
}

void addTransducer(const DccSource &source, XmlElement &list)
{
    const CertificateField *channel = source.field("method", "reference_channel");
    const CertificateField *from = source.field("method", "reference_source");
    const ReferenceRecords *records
        = source.results.reference ? source.results.reference->transducer() : nullptr;
    if (channel && from && records)
        list.add(equipment(
            source, channel->value, from->value, records->certificate, records->sourceSha256));
}

void addChain(const DccSource &source, XmlElement &list)
{
    const CertificateField *field = source.field("method", "chain");
    if (field && source.results.reference && source.results.reference->chain)
        list.add(equipment(source, field->label, field->value,
            source.results.reference->chain->certificate,
            source.results.reference->chain->sourceSha256));
}

void addBudgetReferences(const DccSource &source, XmlElement &list)
{
    for (const BudgetEntry &entry : source.recipe.uncertainty.budget)
        if (const CertificateField *field
            = source.field("method", std::string(kReference) + entry.quantity))
            list.add(
                equipment(source, verbatim(entry.quantity), field->value, entry.certificate, {}));
}

/// One reading, or the least and the largest of several.
XmlElement conditionData(const DccSource &source, const CertificateField &field)
{
    constexpr std::string_view kTo = " \xE2\x80\xA6 ";
    const std::string refType = refTypeOf("conditions." + field.id);
    XmlElement data{"dcc:data"};
    const std::string text
        = field.value.arguments.empty() ? std::string() : field.value.arguments.front();
    const std::size_t at = text.find(kTo);
    if (std::string_view(field.value.text) != "%L1" || at == text.npos) {
        data.add(dccQuantityOf(source.words, field.label, refType, field.value));
        return data;
    }
    data.add(dccQuantityOf(source.words, {DYNCAL_TEXT("core", "Least"), {}},
        refType + " basic_minimum", inNumbers(text.substr(0, at))));
    data.add(dccQuantityOf(source.words, {DYNCAL_TEXT("core", "Largest"), {}},
        refType + " basic_maximum", inNumbers(text.substr(at + kTo.size()))));
    return data;
}

} // namespace

XmlElement dccMethods(const DccSource &source)
{
    XmlElement list{"dcc:usedMethods"};
    if (const CertificateSection *section = source.certificate.section("method"))
        list.add(calibration(source, *section));
    list.add(uncertainty(source));
    if (const CertificateField *drawn = source.field("method", "monte_carlo"))
        list.add(
            method(source, "dyncal_monteCarlo", drawn->label, {drawn->value}, "JCGM 101:2008"));
    list.add(versions(source));
    return list;
}

XmlElement dccUsedSoftware(const DccSource &source)
{
    return {"dcc:usedSoftware", {}, {}, {dccSoftware(source)}};
}

XmlElement dccEquipment(const DccSource &source)
{
    XmlElement list{"dcc:measuringEquipments"};
    addTransducer(source, list);
    addChain(source, list);
    addBudgetReferences(source, list);
    return list.children.empty() ? XmlElement{} : list;
}

XmlElement dccConditions(const DccSource &source)
{
    XmlElement list{"dcc:influenceConditions"};
    const CertificateSection *section = source.certificate.section("conditions");
    for (const CertificateField &field :
        section ? section->fields : std::vector<CertificateField>()) {
        XmlElement condition
            = withRefType("dcc:influenceCondition", refTypeOf("conditions." + field.id));
        condition.add(source.words.element("dcc:name", {field.label}));
        condition.add(conditionData(source, field));
        list.add(std::move(condition));
    }
    return list;
}

} // namespace dyncal
