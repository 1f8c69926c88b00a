// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_sources.h"

namespace dyncal {

/// What came out of it; a section without results says so.
CertificateSection resultsSection(const CertificateSources &sources);
CertificateSection shotsSection(const CertificateSources &sources);
CertificateSection modelSection(const CertificateSources &sources);
CertificateSection frequencyResponseSection(const CertificateSources &sources);
CertificateSection figuresSection(const CertificateSources &sources);

} // namespace dyncal
