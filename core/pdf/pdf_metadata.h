// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// What a PDF says of itself. Texts are UTF-8 without control characters.
struct PdfMetadata
{
    std::string title;
    std::string author; ///< empty: none stated
    std::string creator; ///< the program that made the document
    std::string producer; ///< the one that wrote the PDF
    std::string language; ///< "en", "sv" (BCP 47)
    std::string secondLanguage; ///< empty: none
    std::string createdUtc; ///< ISO 8601 with Z; anything else counts as the beginning of 1970
    /// Properties of Dyncal's own namespace: name and value.
    std::vector<std::pair<std::string, std::string>> marks;
};

/// `utc` as a PDF writes it: "D:20260131120000Z".
std::string pdfDate(const std::string &utc);
/// Of such a date, ISO 8601 with Z; empty where it is none, or in another time zone.
std::string utcOfPdfDate(const std::string &date);

/// The metadata as XMP (ISO 16684-1) with the claim of part 3, level B, and, where there are marks,
/// the description of their namespace that ISO 19005-3, 6.6.2.3.3 asks for. Each mark stands as
/// readable text, so that it is found without reading the PDF (registry/issued).
std::string xmpOf(const PdfMetadata &metadata);

/// What XMP says that the document information says too, and what it claims.
struct ReadXmp
{
    std::string part, conformance; ///< of PDF/A; empty: no claim
    int claims = 0; ///< how often a part is claimed
    std::string title, author, creator, producer, created, modified;
    std::vector<std::string> languages;
    std::vector<std::pair<std::string, std::string>> marks;
    bool describesMarks = false; ///< that there is a description of their namespace
};

/// Of XMP as xmpOf() writes it, of any other what stands at the same places; empty where it is no
/// XML.
std::optional<ReadXmp> readXmp(const std::string &xmp);

} // namespace dyncal
