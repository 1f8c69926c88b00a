// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// Who issues a certificate, and when.
struct IssueNames
{
    std::string by; ///< empty: the operator of the recipe
    std::string reviewedBy = {}; ///< empty: nobody
    std::string utc = {}; ///< ISO 8601 with Z
};

/// The recipe of an issued certificate: its number and date of issue, and the names where the
/// operator typed none. Files that it names are named without their folders; what they hold stays.
Recipe issuedRecipe(Recipe recipe, const std::string &number, const IssueNames &names);

/// Who issues it: `by`, or the operator of the recipe; empty where neither is known.
std::string issuerOf(const Recipe &recipe, const IssueNames &names);

/// What is calibrated: SHA-256 of the hashes of the recordings and of the numbers of their shots,
/// in any order. Needs sealed captures.
std::string jobOf(const CaptureSet &captures);

/// SHA-256 of all that the certificate is made of: recordings, recipe, names, and what it amends.
std::string jobSha256(const CaptureSet &captures, const Recipe &recipe, const IssueNames &names,
    const std::string &amends, const std::string &reason);

/// Decisions of the operator that the audit trail keeps: what was done, and the reason given (empty
/// where none is asked for): shots left out, cautions accepted, the order, the rate, interpolation.
std::vector<std::pair<std::string, std::string>> decisionsOf(
    const CaptureSet &captures, const Recipe &recipe);

/// "Acme 5 17": manufacturer, model and serial number as the certificate states them.
std::string sensorName(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal
