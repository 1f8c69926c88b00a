// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/archive_check.h"

#include "core/certificate/certificate_attachments.h"
#include "core/pdf/pdf_lint.h"

namespace dyncal {
namespace {

using Difference = std::optional<Message>;

Difference compareFile(const PdfFile &inside, const CertificateAttachment &beside)
{
    const PdfAttachment &file = inside.attachment;
    if (file.name != beside.name || file.mime != beside.mime
        || file.relationship != beside.relationship)
        return Message{
            DYNCAL_TEXT("core",
                "The file %1 inside certificate.pdf stands where %2 belongs, or is said to be something else."),
            {file.name, beside.name}};
    if (file.bytes != beside.bytes)
        return Message{
            DYNCAL_TEXT("core", "%1 inside certificate.pdf is not the file %1 beside it."),
            {file.name}};
    return {};
}

Difference compareFiles(
    const std::vector<PdfFile> &inside, const std::vector<CertificateAttachment> &beside)
{
    for (std::size_t i = 0; i < inside.size() && i < beside.size(); ++i)
        if (Difference difference = compareFile(inside[i], beside[i]))
            return difference;
    if (inside.size() < beside.size())
        return Message{DYNCAL_TEXT("core", "%1 is missing inside certificate.pdf."),
            {beside[inside.size()].name}};
    if (inside.size() > beside.size())
        return Message{DYNCAL_TEXT("core",
                           "certificate.pdf has a file inside that does not belong there: %1."),
            {inside[beside.size()].attachment.name}};
    return {};
}

/// What begins as programs before PDF/A-3 wrote it, or is no PDF at all, says nothing of part 3.
bool mayClaim(const std::string &pdf)
{
    return pdf.find("pdfaid") != std::string::npos;
}

} // namespace

std::optional<Message> checkPdfArchive(
    const std::string &pdf, const std::map<std::string, std::string> &beside)
{
    if (!mayClaim(pdf))
        return {};
    const Result<PdfStructure> structure = readPdfStructure(pdf);
    if (!structure)
        return structure.error().message;
    const std::vector<PdfFault> faults = structureFaults(*structure);
    if (!faults.empty())
        return faults.front().message;
    return compareFiles(structure->files, certificateAttachments(beside));
}

} // namespace dyncal
