// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_lint.h"

#include "core/pdf/pdf_metadata.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

using Faults = std::vector<PdfFault>;

Message lacks(const std::string &what)
{
    return {DYNCAL_TEXT("core", "The PDF lacks %1, which an archive needs."), {what}};
}

Message contradicts(const std::string &what)
{
    return {DYNCAL_TEXT("core", "The PDF says two things of %1."), {what}};
}

Message fileLacks(const std::string &name, const std::string &what)
{
    return {DYNCAL_TEXT("core", "The file %1 inside the PDF lacks %2, or has a wrong one."),
        {name, what}};
}

/// ICC.1: "acsp" at byte 36, device class of a screen or printer, three colours.
bool isRgbProfile(const std::string &profile)
{
    constexpr std::size_t kHeader = 128;
    const auto field = [&](std::size_t at) { return std::string_view(profile).substr(at, 4); };
    return profile.size() > kHeader && field(36) == "acsp" && field(16) == "RGB "
        && (field(12) == "mntr" || field(12) == "prtr");
}

void judgeDocument(const PdfStructure &pdf, Faults &faults)
{
    if (!pdf.header.starts_with("%PDF-1.") || pdf.header.size() != 8 || pdf.header.back() < '0'
        || pdf.header.back() > '7')
        faults.push_back({"header", {}, lacks("%PDF-1.n")});
    if (!pdf.isMarkedBinary)
        faults.push_back({"binary-mark", {}, lacks("a comment of four bytes above 127")});
    if (!pdf.hasIdentifier)
        faults.push_back({"identifier", "/ID", lacks("/ID")});
    if (pdf.language.empty())
        faults.push_back({"language", "/Lang", lacks("/Lang")});
    if (!pdf.showsTitle)
        faults.push_back({"title-shown", "/DisplayDocTitle", lacks("/DisplayDocTitle")});
}

/// Information by key, and what the XMP says of the same.
void judgeInformation(const PdfStructure &pdf, const ReadXmp &xmp, Faults &faults)
{
    const auto said = [&](const char *key) {
        const auto found = pdf.information.find(key);
        return found == pdf.information.end() ? std::string() : found->second;
    };
    const std::array<std::tuple<const char *, std::string, std::string>, 6> pairs{
        {{"/Title", said("/Title"), xmp.title}, {"/Author", said("/Author"), xmp.author},
            {"/Creator", said("/Creator"), xmp.creator},
            {"/Producer", said("/Producer"), xmp.producer},
            {"/CreationDate", utcOfPdfDate(said("/CreationDate")), xmp.created},
            {"/ModDate", utcOfPdfDate(said("/ModDate")), xmp.modified}}};
    for (const auto &[key, one, other] : pairs)
        if (one != other)
            faults.push_back({"information", key, contradicts(key)});
    for (const auto &[key, value] : {std::pair{"/Title", xmp.title}, {"/ModDate", xmp.modified}})
        if (value.empty())
            faults.push_back({"information", key, lacks(key)});
}

void judgeMetadata(const PdfStructure &pdf, Faults &faults)
{
    const std::optional<ReadXmp> xmp = readXmp(pdf.xmp);
    if (pdf.xmp.empty() || !xmp || !pdf.isXmpPlain) {
        faults.push_back({"xmp", "/Metadata", lacks("/Metadata")});
        return;
    }
    if (xmp->claims != 1 || xmp->part != "3" || xmp->conformance != "B")
        faults.push_back({"claim", "pdfaid:part", lacks("pdfaid:part 3, pdfaid:conformance B")});
    judgeInformation(pdf, *xmp, faults);
    if (!xmp->marks.empty() && !xmp->describesMarks)
        faults.push_back({"marks", "pdfaExtension:schemas", lacks("pdfaExtension:schemas")});
}

void judgeContents(const PdfStructure &pdf, Faults &faults)
{
    if (pdf.outputIntents.size() != 1 || !isRgbProfile(pdf.outputIntents.front()))
        faults.push_back({"output-intent", "/OutputIntents", lacks("/OutputIntents (sRGB)")});
    if (pdf.bookmarks.empty())
        faults.push_back({"bookmarks", "/Outlines", lacks("/Outlines")});
    for (const std::string &name : pdf.fontsNotEmbedded)
        faults.push_back({"font", name,
            {DYNCAL_TEXT("core", "The font %1 of the PDF is not embedded."), {name}}});
    for (const std::string &name : pdf.forbidden)
        faults.push_back({"forbidden", name,
            {DYNCAL_TEXT("core", "The PDF holds %1, which an archive may not hold."), {name}}});
}

bool isRelationship(const std::string &name)
{
    return std::ranges::find(kPdfRelationships, name) != kPdfRelationships.end();
}

void judgeFile(const PdfFile &file, Faults &faults)
{
    const std::string &name = file.attachment.name.empty() ? file.plainName : file.attachment.name;
    const auto judge = [&](bool isGood, const char *rule, const char *key) {
        if (!isGood)
            faults.push_back({rule, name, fileLacks(name, key)});
    };
    judge(!file.attachment.name.empty() && file.attachment.name == file.plainName, "file-name",
        "/UF, /F");
    judge(isRelationship(file.attachment.relationship), "relationship", "/AFRelationship");
    judge(!file.attachment.description.empty(), "description", "/Desc");
    judge(file.attachment.mime.find('/') != std::string::npos, "mime", "/Subtype");
    judge(!utcOfPdfDate(file.modified).empty(), "date", "/ModDate");
    judge(file.isUnpacked, "file", "/EF");
    if (file.isUnpacked) {
        judge(file.statedSize == std::ssize(file.attachment.bytes), "size", "/Size");
        judge(file.statedChecksum == file.checksum, "checksum", "/CheckSum");
    }
    judge(file.isAssociated, "associated", "/AF");
    judge(file.isNamed, "named", "/Names");
}

} // namespace

std::vector<PdfFault> structureFaults(const PdfStructure &structure)
{
    Faults faults;
    judgeDocument(structure, faults);
    judgeMetadata(structure, faults);
    judgeContents(structure, faults);
    for (const PdfFile &file : structure.files)
        judgeFile(file, faults);
    return faults;
}

Result<std::vector<PdfFault>> lintPdf(const std::string &pdf)
{
    return readPdfStructure(pdf).map(structureFaults);
}

bool claimsArchive(const PdfStructure &structure)
{
    const std::optional<ReadXmp> xmp = readXmp(structure.xmp);
    return xmp && xmp->claims > 0;
}

} // namespace dyncal
