// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/dcc/dcc_finding.h"

#include <string>

namespace dyncal {

/// The rules of PTB's Schematron for the DCC 3 that its schema does not know, and that refTypes of
/// one's own are declared: release like v1.2.3, ids and what refers to them, methods and conditions
/// of every result, lists by single blanks and of one length, units, languages, countries, dates.
/// Fails as checkDcc().
Result<DccCheck> ruleFindings(const std::string &xml);

} // namespace dyncal
