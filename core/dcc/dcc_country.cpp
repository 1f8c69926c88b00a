// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_country.h"

#include "core/dcc/iso_codes.h"
#include "core/dcc/xml_element.h"

#include <array>
#include <utility>

namespace dyncal {

std::string dccCountry(const Recipe &recipe, const std::string &whose)
{
    const auto &fields = recipe.certificate.fields;
    const auto typed = fields.find(whose + "_country");
    if (typed != fields.end() && isCountryCode(inOneLine(typed->second)))
        return inOneLine(typed->second);
    const auto address = fields.find(whose + "_address");
    return address == fields.end() ? kNoCountry : countryOf(address->second);
}

Findings countryCautions(const Recipe &recipe)
{
    constexpr std::array kParties{
        std::pair{"laboratory",
            DYNCAL_TEXT("core",
                "The DCC names no country of the laboratory (it has ZZ): there is no code of ISO 3166-1, as SE, in its country field and none in its address; type it into the fields of the certificate or into the laboratory's card.")},
        std::pair{"customer",
            DYNCAL_TEXT("core",
                "The DCC names no country of the customer (it has ZZ): there is no code of ISO 3166-1, as SE, in its country field and none in its address; type it into the fields of the certificate or into the customer's card.")}};
    Findings findings;
    for (const auto &[whose, sentence] : kParties)
        if (dccCountry(recipe, whose) == kNoCountry)
            findings.push_back(
                {.id = "CER-010", .severity = Severity::Caution, .message = {sentence, {}}});
    return findings;
}

} // namespace dyncal
