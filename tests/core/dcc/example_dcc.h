// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate.h"
#include "core/certificate/certificate_issue.h"
#include "core/dcc/dcc_document.h"
#include "tests/support/example_results.h"

#include <string>
#include <vector>

namespace dyncal::testing {

/// A recipe with everything that a certificate and its DCC need.
inline Recipe exampleDccRecipe(std::vector<std::string> languages = {"en"})
{
    Recipe recipe;
    recipe.certificate.fields = example::certificateFields();
    recipe.certificate.fields["laboratory_country"] = "SE";
    recipe.certificate.fields["customer_country"] = "SE";
    recipe.certificate.languages = std::move(languages);
    return recipe;
}

inline constexpr const char *kExampleCreated = "2026-11-21T03:04:05Z";

/// The DCC of results and a recipe; issued, or a draft.
inline std::string dccOfRecipe(const CalibrationResults &results, const Recipe &recipe,
    const std::optional<CertificateIssue> &issue = {}, const DccTranslation &translate = {})
{
    CertificateData data = makeCertificate(results, recipe, kExampleCreated);
    if (issue)
        markIssued(*issue, data);
    return dccText(data, results, recipe, issue, translate);
}

/// What a part of a DCC is made from, to be changed by a test.
struct ExampleSource
{
    CalibrationResults results = example::calibration();
    Recipe recipe = exampleDccRecipe();
    std::optional<CertificateIssue> issue = {};
    DccWords words = {};
    CertificateData certificate = {};

    /// Makes the certificate anew and shows it with the rest, which must stay where it is.
    DccSource source()
    {
        certificate = makeCertificate(results, recipe, kExampleCreated);
        if (issue)
            markIssued(*issue, certificate);
        return {certificate, results, recipe, issue, words};
    }
    std::string &field(const std::string &id) { return recipe.certificate.fields[id]; }
};

/// Certificate 17, bound to hashes that are told apart.
inline CertificateIssue exampleIssue()
{
    return {"17", "", "", std::string(64, 'a'), std::string(64, 'b')};
}

/// English, and in its place "sv: " before each sentence that is ours.
inline DccWords exampleWordsInTwo()
{
    return {{"en", "sv"}, [](const Message &message, const std::string &language) {
                const bool isOurs = !std::string_view(message.text).starts_with('%');
                return (language == "sv" && isOurs ? "sv: " : "") + english(message);
            }};
}

inline std::string exampleDcc()
{
    return dccOfRecipe(example::calibration(), exampleDccRecipe());
}

/// `text` with the first `what` replaced; as it was where it is not there.
inline std::string replacedOnce(std::string text, const std::string &what, const std::string &with)
{
    if (const std::size_t at = text.find(what); at != text.npos)
        text.replace(at, what.size(), with);
    return text;
}

} // namespace dyncal::testing
