// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"

#include "core/certificate/certificate_header_sections.h"
#include "core/certificate/certificate_method_sections.h"
#include "core/certificate/certificate_result_sections.h"
#include "core/certificate/certificate_words.h"

#include <map>
#include <vector>

namespace dyncal {

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
    data.title = {DYNCAL_TEXT("core", "Certificate of dynamic calibration"), {}};
    data.sections = {administrativeSection(recipe), itemSection(results, recipe),
        methodSection(results, recipe), conditionsSection(results, recipe), resultsSection(results),
        shotsSection(results), modelSection(results, recipe), frequencyResponseSection(results),
        remarksSection(results, recipe), recordsSection(results, createdUtc), statementsSection(),
        figuresSection(results)};
    return data;
}

} // namespace dyncal
