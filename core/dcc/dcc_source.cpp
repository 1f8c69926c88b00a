// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_source.h"

#include <algorithm>
#include <string_view>

namespace dyncal {

const CertificateField *DccSource::field(const std::string &section, const std::string &id) const
{
    const CertificateSection *part = certificate.section(section);
    if (!part)
        return nullptr;
    const auto found = std::ranges::find(part->fields, id, &CertificateField::id);
    return found == part->fields.end() ? nullptr : &*found;
}

const UncertainResponse *DccSource::comparisonBeside() const
{
    const auto &comparison = results.comparison;
    const bool isBeside = comparison && comparison->byTransducer && results.response
        && !results.response->isByTransducer;
    return isBeside ? &*comparison->byTransducer : nullptr;
}

std::string DccSource::typed(const std::string &section, const std::string &id) const
{
    const CertificateField *there = field(section, id);
    const bool isTyped = there && !there->missing && std::string_view(there->value.text) == "%1"
        && !there->value.arguments.empty();
    const std::string line = isTyped ? inOneLine(there->value.arguments.front()) : std::string();
    return line == "\xE2\x80\x93" ? std::string() : line;
}

} // namespace dyncal
