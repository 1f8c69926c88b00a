// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <functional>
#include <string>

namespace dyncal {

/// Named destination of a PDF, with a rectangle (/FitR), over which its signature is to be seen.
inline constexpr const char *kSignaturePlace = "signature";

/// What an incremental update must know of a PDF, and the two objects that it replaces.
struct PdfOutline
{
    int size = 0; ///< the first free object number
    int root = 0, rootGeneration = 0; ///< catalog
    int page = 0, pageGeneration = 0; ///< that of the signature's place; else the first
    std::string rootReference, pageReference; ///< "3 0 R"
    std::string rootContent; ///< with the field in its /AcroForm
    std::string pageContent; ///< with the annotation in its /Annots
    std::string rectangle; ///< of the signature's place, "[57 90 538 140]"; empty: there is none
    std::string trailerRest; ///< /Info and /ID, as far as there are any
    std::size_t table = 0; ///< where the last cross-reference table begins

    bool isSeen() const { return !rectangle.empty(); }
};

/// References that go into the catalog's form and among the first page's annotations.
struct PdfAdditions
{
    std::string field;
    std::string annotation;
};

/// Reads a PDF (libqpdf, without repairing anything); `added` gets its first free object number.
/// Fails as withSignatureField() does.
Result<PdfOutline> outlineOf(
    const std::string &pdf, const std::function<PdfAdditions(int size)> &added);

/// A text as a PDF string: UTF-16 with its mark, in hexadecimal digits; of invalid UTF-8 what is
/// valid.
std::string pdfTextString(const std::string &utf8);

} // namespace dyncal
