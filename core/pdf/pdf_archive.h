// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/pdf/pdf_metadata.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// What a file inside a PDF can be to the document (ISO 19005-3, annex E).
inline constexpr std::array<std::string_view, 5> kPdfRelationships{
    "Source", "Data", "Alternative", "Supplement", "Unspecified"};

/// A file inside a PDF.
struct PdfAttachment
{
    std::string name; ///< without folders, not empty, each once
    std::string mime; ///< "application/json"
    std::string relationship; ///< one of kPdfRelationships
    std::string description; ///< UTF-8
    std::string bytes;

    bool operator==(const PdfAttachment &) const = default;
};

/// A line of the list of contents that a viewer shows beside the pages.
struct PdfBookmark
{
    std::string title; ///< UTF-8
    int page = 0; ///< from 0
    double height_pt
        = 0.0; ///< of the place above the lower edge of the page, in points (1/72 inch)
};

/// A rectangle on a page, in points from its lower left corner.
struct PdfPlace
{
    int page = 0; ///< from 0
    double left_pt = 0.0;
    double bottom_pt = 0.0;
    double right_pt = 0.0;
    double top_pt = 0.0;
};

/// What the structure of PDF/A-3 asks for besides the pages.
struct PdfArchive
{
    PdfMetadata metadata;
    std::string colorProfile; ///< ICC profile of the colours on the pages, an RGB one
    std::vector<PdfBookmark> bookmarks;
    std::vector<PdfAttachment> attachments;
    std::optional<PdfPlace> signature = {}; ///< where a signature is to be seen (kSignaturePlace)
};

/// The PDF with the structure of PDF/A-3 (ISO 19005-3, level B): metadata (XMP) that say the same
/// as the document information, an output intent, attachments as associated files with
/// relationship, type, size, date and checksum, the language, bookmarks, the title in the title
/// bar. `pdf` is what QPdfWriter wrote: fonts embedded, no encryption; its pages are not touched.
/// The same arguments give the same bytes, of any dates and identifier in `pdf`: a file of
/// version 1.7 with one cross-reference table and no object streams, to which a signature can be
/// appended. Fails (Internal) where `pdf` is no PDF, the page of a bookmark or place is missing, or
/// an attachment's name or relationship is none.
Result<std::string> withArchiveStructure(const std::string &pdf, const PdfArchive &archive);

} // namespace dyncal
