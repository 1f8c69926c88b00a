// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_attachments.h"

namespace dyncal {

std::vector<CertificateAttachment> certificateAttachments(
    const std::map<std::string, std::string> &files)
{
    std::vector<CertificateAttachment> attachments{
        {"dcc.xml", "application/xml", "Alternative",
            {DYNCAL_TEXT("core", "This certificate for machines (DCC)"), {}}, {}},
        {"results.json", "application/json", "Data",
            {DYNCAL_TEXT("core", "All results, unrounded, with their budgets"), {}}, {}},
        {"recipe.json", "application/json", "Supplement",
            {DYNCAL_TEXT("core", "Every decision of the evaluation"), {}}, {}},
    };
    std::erase_if(
        attachments, [&](const CertificateAttachment &one) { return !files.contains(one.name); });
    for (CertificateAttachment &one : attachments)
        one.bytes = files.at(one.name);
    return attachments;
}

} // namespace dyncal
