// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_statements.h"

#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/certificate/conformity.h"
#include "core/dcc/dcc_fields.h"
#include "core/dcc/dcc_quantity.h"

#include <array>
#include <optional>
#include <utility>

namespace dyncal {
namespace {

constexpr const char *kStandard = "ISO/IEC 17025:2017";

/// In the order that the schema wants: name, traceable, norm, reference, declaration.
struct Statement
{
    std::string refType;
    std::optional<Message> name = {};
    std::optional<bool> traceable = {};
    std::string norm = {};
    std::string reference = {};
    std::vector<Message> declaration = {};
};

XmlElement elementOf(const DccSource &source, const Statement &statement)
{
    XmlElement element = withRefType("dcc:statement", statement.refType);
    if (statement.name)
        element.add(source.words.element("dcc:name", {*statement.name}));
    if (statement.traceable)
        element.add({"dcc:traceable", {}, *statement.traceable ? "true" : "false"});
    if (!statement.norm.empty())
        element.add({"dcc:norm", {}, statement.norm});
    if (!statement.reference.empty())
        element.add({"dcc:reference", {}, statement.reference});
    if (!statement.declaration.empty())
        element.add(source.words.element("dcc:declaration", statement.declaration));
    return element;
}

std::vector<Message> draftWords(const DccSource &source)
{
    std::vector<Message> said{
        {DYNCAL_TEXT("core",
             "This is a draft and no certificate: it has no number, and what it says may change."),
            {}}};
    for (const Message &label : source.certificate.missingFields())
        said.push_back(
            {DYNCAL_TEXT("core", "Not stated yet; what stands in its place says nothing:"), {},
                {label}});
    return said;
}

/// The sentences of the certificate with the clause each is asked for by, in their order.
void addSentences(const DccSource &source, XmlElement &list)
{
    constexpr std::array kClauses{"7.8.2.1 l", "7.8.2.1", "7.8.6.2", "7.8.4.1 c"};
    const CertificateSection *section = source.certificate.section("statements");
    for (std::size_t i = 0; section && i < section->paragraphs.size(); ++i) {
        Statement statement{"dyncal_statement", {}, {}, kStandard, {}, {section->paragraphs[i]}};
        if (i < kClauses.size())
            statement.reference = kClauses[i];
        if (i + 1 == kClauses.size())
            statement.traceable = source.issue.has_value();
        list.add(elementOf(source, statement));
    }
    list.add(elementOf(source,
        {"dyncal_statement", {}, {}, kStandard, "7.8.4.3",
            {{DYNCAL_TEXT("core", "No interval until the next calibration is recommended."),
                {}}}}));
}

/// A section's fields as quantities, and its notes.
XmlElement dataOf(const DccSource &source, const CertificateSection &section)
{
    XmlElement data{"dcc:data"};
    for (const CertificateField &field : section.fields)
        data.add(dccQuantityOf(
            source.words, field.label, refTypeOf(section.id + "." + field.id), field.value));
    return data;
}

std::string normOf(DecisionRule rule)
{
    return rule == DecisionRule::Risk ? "JCGM 106:2012" : "ILAC-G8:09/2019";
}

XmlElement percent(const DccSource &source, const char *place, const Message &name, double value,
    double u = kUnknown, double k = kCoverageFactor)
{
    return dccQuantityOf(
        source.words, name, refTypeOf(place), printedWithUncertainty(value, u, "%", k));
}

void addJudged(const DccSource &source, const DecisionSettings &decision, const JudgedRow &worst,
    XmlElement &data)
{
    constexpr double kPercent = 100.0;
    data.add(percent(source, "conformity/limit",
        {DYNCAL_TEXT("core", "Largest deviation allowed"), {}}, decision.within_percent));
    data.add(dccQuantityOf(source.words, {DYNCAL_TEXT("core", "Worst frequency"), {}},
        refTypeOf("conformity/frequency"), setting(worst.frequency_Hz, "Hz")));
    data.add(percent(source, "conformity/deviation", {DYNCAL_TEXT("core", "Deviation"), {}},
        kPercent * worst.deviation, kPercent * worst.u, worst.k));
    data.add(dccQuantityOf(source.words,
        {DYNCAL_TEXT("core", "Probability of lying beyond the limit"), {}},
        refTypeOf("conformity/risk"), inNumbers(numberText(kPercent * worst.risk, 2) + " %")));
}

/// No verdict where none was possible: the schema's words would each say more.
void addConformity(const DccSource &source, XmlElement &list)
{
    const CertificateSection *section = source.certificate.section("conformity");
    if (!section || !source.recipe.certificate.decision)
        return;
    const DecisionSettings &decision = *source.recipe.certificate.decision;
    const ConformityResult judged = judgeConformity(
        source.results.response ? *source.results.response : ResponseResult(), decision);
    std::vector<Message> declaration;
    for (const CertificateField &field : section->fields)
        declaration.push_back(field.value);
    declaration.insert(declaration.end(), section->notes.begin(), section->notes.end());
    XmlElement statement = elementOf(source,
        {"dyncal_conformityStatement", section->title, {}, normOf(decision.rule), {}, declaration});
    if (judged.verdict != ConformityVerdict::NoStatement)
        statement.add({"dcc:conformity", {},
            judged.verdict == ConformityVerdict::Conforms ? "pass" : "fail"});
    XmlElement data = dataOf(source, *section);
    if (judged.worst)
        addJudged(source, decision, *judged.worst, data);
    statement.add(std::move(data));
    list.add(std::move(statement));
}

void addPlace(const DccSource &source, XmlElement &list)
{
    if (const CertificateField *place = source.field("administrative", "place"))
        list.add(elementOf(source,
            {"dyncal_placeOfCalibration", place->label, {}, kStandard, "7.8.2.1 c",
                {place->value}}));
}

void addIssue(const DccSource &source, XmlElement &list)
{
    const CertificateSection *section = source.certificate.section("issue");
    if (!section)
        return;
    std::vector<Message> said = section->notes;
    if (const CertificateField *amends = source.field("administrative", "amends"))
        said.push_back(amends->value);
    XmlElement statement
        = elementOf(source, {"dyncal_issue", section->title, {}, {}, {}, std::move(said)});
    statement.add(dataOf(source, *section));
    list.add(std::move(statement));
}

} // namespace

XmlElement dccStatements(const DccSource &source)
{
    XmlElement list{"dcc:statements"};
    if (!source.issue)
        list.add(elementOf(source, {"dyncal_draft", {}, {}, {}, {}, draftWords(source)}));
    addSentences(source, list);
    addPlace(source, list);
    addConformity(source, list);
    addIssue(source, list);
    return list;
}

} // namespace dyncal
