// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_sources.h"
#include "core/pipeline/pipeline.h"
#include "core/project/recipe.h"

namespace dyncal {

/// What the certificate is written from; points into `results`, which must outlive it.
CertificateSources certificateSources(
    const CalibrationResults &results, const Recipe &recipe, const std::string &createdUtc);

} // namespace dyncal
