// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"

#include "core/certificate/certificate_conditions_section.h"
#include "core/certificate/certificate_conformity.h"
#include "core/certificate/certificate_frequency_section.h"
#include "core/certificate/certificate_header_sections.h"
#include "core/certificate/certificate_key_section.h"
#include "core/certificate/certificate_method_sections.h"
#include "core/certificate/certificate_result_sections.h"
#include "core/certificate/certificate_templates.h"
#include "core/certificate/certificate_words.h"

#include <map>
#include <optional>
#include <vector>

namespace dyncal {
namespace {

constexpr int kBehindKeyResults = 3; ///< of the sections

} // namespace

CertificateData makeCertificate(
    const CalibrationResults &results, const Recipe &recipe, const std::string &createdUtc)
{
    const std::vector<std::string> &languages = recipe.certificate.languages;
    const std::map<std::string, std::string> &fields = recipe.certificate.fields;
    CertificateData data;
    data.language = languages.empty() ? "en" : languages.front();
    data.createdUtc = createdUtc;
    if (const auto number = fields.find("certificate_number");
        number != fields.end() && !isBlank(number->second))
        data.number = number->second;
    data.title = certificateTitle(calibrationKind(results, recipe));
    const std::optional<CertificateSection> conformity = conformitySection(results, recipe);
    data.sections = {administrativeSection(recipe), itemSection(results, recipe),
        keyResultsSection(results, recipe), methodSection(results, recipe),
        conditionsSection(results, recipe), resultsSection(results, recipe),
        shotsSection(results, recipe), modelSection(results, recipe),
        frequencyResponseSection(results, recipe), remarksSection(results, recipe),
        recordsSection(results, createdUtc), statementsSection(recipe),
        figuresSection(results, recipe)};
    if (conformity) // on the first page, behind what it judges
        data.sections.insert(data.sections.begin() + kBehindKeyResults, *conformity);
    return data;
}

} // namespace dyncal
