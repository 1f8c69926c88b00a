// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

#include <string>

namespace dyncal {

/// Name of the file beside certificate.pdf.
inline constexpr const char *kDccFile = "dcc.xml";

/// The digital calibration certificate (PTB DCC 3.3.0, D-SI 2.2.1) of a certificate: what its pages
/// say, numbers digit by digit as printed, and what results.json has beside them (dcc_exact.h,
/// dcc_budget.h). Figures are left out. Without `issue` it says that it is a draft. The same source
/// gives the same bytes. docs/dcc.md has the table of what stands where.
std::string dccText(const DccSource &source);

/// The same in the certificate's languages.
std::string dccText(const CertificateData &certificate, const CalibrationResults &results,
    const Recipe &recipe, const std::optional<CertificateIssue> &issue,
    const DccTranslation &translate);

} // namespace dyncal
