// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_data.h"

#include <algorithm>

namespace dyncal {

std::vector<Message> CertificateData::missingFields() const
{
    std::vector<Message> labels;
    for (const CertificateSection &part : sections)
        for (const CertificateField &field : part.fields)
            if (field.missing)
                labels.push_back(field.label);
    return labels;
}

const CertificateSection *CertificateData::section(const std::string &id) const
{
    const auto found = std::find_if(sections.begin(), sections.end(),
        [&id](const CertificateSection &part) { return part.id == id; });
    return found == sections.end() ? nullptr : &*found;
}

} // namespace dyncal
