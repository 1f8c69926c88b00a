// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/json_record.h"
#include "core/results/results_context.h"

#include <string>

namespace dyncal {

/// The keys of a section "response". `report`: its uncertainties; null where there are none, for
/// the reason `whyMissing`.
JsonRecord responseSection(
    const ResponseResult &response, const UncertaintyReport *report, const std::string &whyMissing);

/// The sections "response" and "bands" of results.json.
void addResponse(JsonRecord &root, const ResultsContext &context);
void addBands(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal
