// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pdf/pdf_structure.h"

namespace dyncal {

/// One thing that the structure of PDF/A-3 asks for and a PDF lacks.
struct PdfFault
{
    /// Which rule, stable: "header", "binary-mark", "identifier", "language", "title-shown", "xmp",
    /// "claim", "information", "marks", "output-intent", "bookmarks", "font", "forbidden",
    /// "file-name", "relationship", "description", "mime", "date", "size", "checksum",
    /// "associated", "named", "file"
    std::string rule;
    std::string where; ///< name of the file, font or key concerned; empty: the document
    Message message;
};

/// What is missing or contradicts, in the order of the rules above; empty where nothing is. The
/// rules are those of docs/certificate.md, "The file", with their clauses of ISO 19005-3: keys of
/// the structure, not what page contents and font programs hold.
std::vector<PdfFault> structureFaults(const PdfStructure &structure);

/// Of a PDF's bytes. Fails as readPdfStructure().
Result<std::vector<PdfFault>> lintPdf(const std::string &pdf);

/// Whether a PDF claims the structure of PDF/A-3, and so must keep its rules.
bool claimsArchive(const PdfStructure &structure);

} // namespace dyncal
