// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate.h"

#include "core/certificate/certificate_header_sections.h"
#include "core/certificate/certificate_method_sections.h"
#include "core/certificate/certificate_result_sections.h"
#include "core/certificate/certificate_words.h"

namespace dyncal {

CertificateData makeCertificate(const CertificateSources &sources)
{
    CertificateData data;
    data.language = sources.language;
    data.createdUtc = sources.createdUtc;
    if (const auto number = sources.fields.find("certificate_number");
        number != sources.fields.end() && !isBlank(number->second))
        data.number = number->second;
    data.title = {DYNCAL_TEXT("core", "Certificate of dynamic calibration"), {}};
    data.sections = {administrativeSection(sources), itemSection(sources), methodSection(sources),
        conditionsSection(sources), resultsSection(sources), shotsSection(sources),
        modelSection(sources), frequencyResponseSection(sources), remarksSection(sources),
        recordsSection(sources), statementsSection(sources), figuresSection(sources)};
    return data;
}

} // namespace dyncal
