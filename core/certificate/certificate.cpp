// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"

#include "core/certificate/certificate_conditions_section.h"
#include "core/certificate/certificate_conformity.h"
#include "core/certificate/certificate_figures.h"
#include "core/certificate/certificate_frequency_section.h"
#include "core/certificate/certificate_header_sections.h"
#include "core/certificate/certificate_history.h"
#include "core/certificate/certificate_key_section.h"
#include "core/certificate/certificate_method_sections.h"
#include "core/certificate/certificate_result_sections.h"
#include "core/certificate/certificate_signature.h"
#include "core/certificate/certificate_templates.h"
#include "core/certificate/certificate_words.h"

#include <map>
#include <optional>
#include <vector>

namespace dyncal {
namespace {

/// What the sections are made of.
struct Content
{
    const CalibrationResults &results;
    const Recipe &recipe;
    const std::string &createdUtc;
    const CertificateTemplate &layout;
};

using Maker = CertificateSection (*)(const Content &);

const std::map<std::string, Maker> &makers()
{
    using C = const Content &;
    static const std::map<std::string, Maker> known{
        {"administrative", [](C c) { return administrativeSection(c.recipe); }},
        {"item", [](C c) { return itemSection(c.results, c.recipe); }},
        {"key-results", [](C c) { return keyResultsSection(c.results, c.recipe, c.layout); }},
        {"method", [](C c) { return methodSection(c.results, c.recipe); }},
        {"conditions", [](C c) { return conditionsSection(c.results, c.recipe); }},
        {"results", [](C c) { return resultsSection(c.results, c.recipe, c.layout); }},
        {"shots", [](C c) { return shotsSection(c.results, c.recipe); }},
        {"model", [](C c) { return modelSection(c.results, c.recipe); }},
        {"frequency-response", [](C c) { return frequencyResponseSection(c.results, c.recipe); }},
        {kHistorySection, [](C) { return historyToCome(); }},
        {kSignatureSection, [](C) { return signatureToCome(); }},
        {"remarks", [](C c) { return remarksSection(c.results, c.recipe); }},
        {"records", [](C c) { return recordsSection(c.results, c.createdUtc); }},
        {"statements", [](C c) { return statementsSection(c.results, c.recipe); }},
        {"figures", [](C c) { return figuresSection(c.results, c.recipe, c.layout.figures); }},
    };
    return known;
}

std::vector<CertificateSection> sectionsOf(const Content &content)
{
    std::vector<CertificateSection> sections;
    for (const std::string &id : content.layout.sections) {
        sections.push_back(makers().at(id)(content));
        if (id != "key-results")
            continue;
        if (auto conformity = conformitySection(content.results, content.recipe))
            sections.push_back(std::move(*conformity)); // behind what it judges
    }
    return sections;
}

std::string typedNumber(const Recipe &recipe)
{
    const auto number = recipe.certificate.fields.find("certificate_number");
    const bool isThere = number != recipe.certificate.fields.end() && !isBlank(number->second);
    return isThere ? number->second : std::string();
}

/// The template's in the document's languages; in none of them: by what the results are.
Message titleOf(const CertificateTemplate &layout, const std::vector<std::string> &languages,
    CalibrationKind kind)
{
    std::string title;
    for (const std::string &language : languages)
        if (const auto found = layout.title.find(language); found != layout.title.end())
            title += (title.empty() ? "" : " / ") + found->second;
    return title.empty() ? certificateTitle(kind) : verbatim(title);
}

} // namespace

CertificateData makeCertificate(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen)
{
    const std::vector<std::string> &languages = documentLanguages(chosen, recipe);
    CertificateData data;
    data.language = languages.empty() ? "en" : languages.front();
    const bool isInTwo = languages.size() > 1 && languages[1] != languages[0];
    data.secondLanguage = isInTwo ? languages[1] : std::string();
    data.createdUtc = createdUtc;
    data.number = typedNumber(recipe);
    data.title = titleOf(chosen.layout, languages, calibrationKind(results, recipe));
    data.sections = sectionsOf({results, recipe, createdUtc, chosen.layout});
    data.logo = {chosen.logo, chosen.layout.logo.ends_with(".svg")};
    return data;
}

} // namespace dyncal
