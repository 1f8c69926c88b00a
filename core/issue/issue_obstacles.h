// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/issue/issued_recipe.h"
#include "core/pipeline/pipeline.h"

namespace dyncal {

/// All that keeps a certificate from being issued, most urgent first; empty where nothing does.
/// `recipe`: as issuedRecipe() makes it, with any number.
/// - whatever keeps results from leaving the program (publicationObstacle), and nothing else then;
/// - CER-001 a field that must be there is empty or wrong;
/// - CER-002 a caution without a reason;
/// - CER-003 a reference whose certificate ended before the measurement;
/// - CER-005 the profile demands a second name, and there is none or it is the issuer's;
/// - CER-008 a reported quantity lacks its complete uncertainty;
/// - CER-009 an input of the budget that a reference is behind names no certificate of one.
Findings issueObstacles(
    const PipelineOutcome &outcome, const Recipe &recipe, const IssueNames &names);

/// CER-004: what is on show was computed from another recipe or other recordings than there are
/// now.
Finding staleResults();

} // namespace dyncal
