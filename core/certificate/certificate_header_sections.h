// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_sources.h"

namespace dyncal {

/// Who, what, remarks, records and statements: sections that need no results.
CertificateSection administrativeSection(const CertificateSources &sources);
CertificateSection itemSection(const CertificateSources &sources);
CertificateSection remarksSection(const CertificateSources &sources);
CertificateSection recordsSection(const CertificateSources &sources);
CertificateSection statementsSection(const CertificateSources &sources);

} // namespace dyncal
