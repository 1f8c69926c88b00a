// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/required_fields.h"

#include "core/certificate/certificate_header_sections.h"
#include "core/certificate/certificate_method_sections.h"

namespace dyncal {

std::vector<CertificateField> unfilledFields(
    const CalibrationResults &results, const Recipe &recipe)
{
    std::vector<CertificateField> unfilled;
    for (const CertificateSection &section : {administrativeSection(recipe),
             itemSection(results, recipe), methodSection(results, recipe)})
        for (const CertificateField &field : section.fields)
            if (field.missing)
                unfilled.push_back(field);
    return unfilled;
}

} // namespace dyncal
