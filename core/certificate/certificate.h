// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_sources.h"

namespace dyncal {

/// The whole certificate of what is there; sections without results say so.
CertificateData makeCertificate(const CertificateSources &sources);

} // namespace dyncal
