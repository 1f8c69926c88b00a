// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_issue.h"
#include "core/dcc/dcc_finding.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"
#include "core/project/template_choice.h"

#include <optional>
#include <string>

namespace dyncal {

/// The DCC of a certificate (dccText()) with the words of its pages, in its languages, whatever
/// language is installed.
std::string certificateDcc(const CertificateData &certificate, const CalibrationResults &results,
    const Recipe &recipe, const std::optional<CertificateIssue> &issue);

/// What of a draft's DCC is not as it must be (checkDcc(), without the schema). Needs no thread of
/// its own.
Result<DccCheck> draftDccCheck(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen);

} // namespace dyncal
