// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_sources.h"

namespace dyncal {

/// How and under which conditions it was calibrated.
CertificateSection methodSection(const CertificateSources &sources);
CertificateSection conditionsSection(const CertificateSources &sources);

} // namespace dyncal
