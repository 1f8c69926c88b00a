// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// The section of what earlier certificates of the sensor state; no template that comes with the
/// program has it.
inline constexpr const char *kHistorySection = "history";
/// The section over which a signed certificate has the field of its signature, to be seen; no
/// template that comes with the program has it.
inline constexpr const char *kSignatureSection = "signature";

/// What a document of results shows, and in which order: a file "dyncal-template/1", which a
/// laboratory edits (docs/certificate.md). The defaults are the template "accredited".
struct CertificateTemplate
{
    std::map<std::string, std::string> title = {}; ///< by language; without: by the calibration
    std::vector<std::string> sections
        = {"administrative", "item", "key-results", "method", "conditions", "results", "shots",
            "model", "frequency-response", "remarks", "records", "statements", "figures"};
    std::vector<std::string> figures
        = {"singular-values", "model-data", "model-error", "step", "magnitude", "phase",
            "comparison", "spectrum", "pole-zero"}; ///< in this order, as far as they exist
    std::optional<std::vector<std::string>> quantities = {}; ///< key results; empty: all
    std::optional<std::vector<std::string>> languages = {}; ///< one or two; empty: the recipe's
    std::string logo = {}; ///< file beside the template; "" = none

    bool operator==(const CertificateTemplate &) const = default;

    /// Whether the key results have this quantity.
    bool states(const std::string &quantity) const;
};

/// Every section that a template may have.
const std::vector<std::string> &templateSections();
/// Those that none may leave out: what ISO/IEC 17025, 7.8.2 and 7.8.4, asks for.
const std::vector<std::string> &requiredSections();
/// Every figure that a template may have.
const std::vector<std::string> &templateFigures();
/// Every quantity of the key results, by the name that results.json has for it.
const std::vector<std::string> &templateQuantities();
/// Those that none may leave out.
const std::vector<std::string> &requiredQuantities();

/// Reads a template. Fails (Usage) on malformed JSON (line and column), on an unknown key (names
/// the nearest), on a value that is none of those it may be, on a list that names something twice,
/// on a section or quantity that must be there and is not (names it), on key results behind
/// anything but laboratory and item (page 1 holds them), on figures without their section.
Result<CertificateTemplate> parseTemplate(const std::string &json);

/// The template as JSON, every default filled in. parseTemplate(templateJson(t)) == t.
std::string templateJson(const CertificateTemplate &layout);

} // namespace dyncal
