// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_history.h"

namespace dyncal {

CertificateSection historyToCome()
{
    CertificateSection section;
    section.id = kHistorySection;
    section.title = {DYNCAL_TEXT("core", "Earlier calibrations"), {}};
    section.paragraphs.push_back(
        {DYNCAL_TEXT("core",
             "When the certificate is issued, the laboratory's certificates of this sensor that are in force are stated here."),
            {}});
    return section;
}

} // namespace dyncal
