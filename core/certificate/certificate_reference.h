// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <optional>
#include <vector>

namespace dyncal {

/// The reference transducer of a comparison: channel, certificate, hash of its file or the numbers
/// that were stated in its place, with U. None without a comparison.
std::vector<CertificateField> referenceFields(
    const CalibrationResults &results, const Recipe &recipe);

/// What the comparison of step and transducer found; empty where it could not be made.
std::optional<Message> comparisonSentence(const CalibrationResults &results);

} // namespace dyncal
