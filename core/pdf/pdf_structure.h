// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/pdf/pdf_archive.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace dyncal {

/// A file specification with an embedded file, as it stands in a PDF.
struct PdfFile
{
    PdfAttachment attachment; ///< name: that of /UF
    std::string plainName; ///< that of /F
    bool isAssociated = false; ///< stands in /AF of the catalog
    bool isNamed = false; ///< stands in the tree of embedded files
    bool isUnpacked = false; ///< its bytes are known: false where they are not to be had
    std::string modified; ///< /ModDate, as it stands
    Index statedSize = -1; ///< -1: none
    std::string statedChecksum; ///< MD5, 16 bytes; empty: none
    std::string checksum; ///< of the bytes
};

/// What a PDF's structure says, as values: what pdf_lint judges.
struct PdfStructure
{
    std::string header; ///< first line
    bool isMarkedBinary = false; ///< four bytes above 127 follow in a comment
    bool hasIdentifier = false; ///< /ID of two strings in the trailer
    std::string language; ///< /Lang of the catalog
    bool showsTitle = false; ///< /DisplayDocTitle
    std::map<std::string, std::string> information; ///< texts by key ("/Title")
    std::string xmp; ///< "": none, or not to be had
    bool isXmpPlain = false; ///< without a filter
    std::vector<std::string> outputIntents; ///< ICC profile of each that is for PDF/A; "": none
    std::vector<std::string> bookmarks; ///< their titles, as far as they are linked
    std::set<std::string> fontsNotEmbedded; ///< by name
    std::set<std::string> forbidden; ///< names of what an archive may not hold ("/JavaScript")
    std::vector<PdfFile> files;
};

/// Size in bytes above which a PDF is not read.
inline constexpr std::size_t kLargestPdf = std::size_t(64) << 20U;
/// Bytes that all streams of a PDF together may unpack to: 64 MiB and 20 times its size (adr/0019).
std::size_t unpackedLimit(std::size_t fileBytes);

/// Reads a PDF of anybody's: nothing is repaired, no object streams (the hidden kind that may
/// unpack to anything), no more unpacked than unpackedLimit(), loops are left. Fails
/// (FileUnreadable) where it is too large, has more than 100 000 objects, is damaged, encrypted or
/// has no cross-reference table.
Result<PdfStructure> readPdfStructure(const std::string &pdf);

/// The files inside a PDF in the order of /AF, those outside of it behind them. Fails as
/// readPdfStructure(), and where one cannot be unpacked.
Result<std::vector<PdfAttachment>> attachmentsOf(const std::string &pdf);

} // namespace dyncal
