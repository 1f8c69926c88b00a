// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/uncertainty_settings.h"
#include "core/uncertainty/uncertainty_report.h"

#include <string>
#include <vector>

namespace dyncal {

/// The least U that the laboratory states of a value, in its unit: the largest of the entries for
/// this quantity (and frequency); 0 without one.
double leastExpanded(const std::vector<CapabilityEntry> &cmc, const std::string &of, double value,
    double frequency_Hz = 0.0);

/// Whether the laboratory states a CMC for rows of S(f), and none at this frequency: it is not
/// accredited there.
bool isOutsideScope(const std::vector<CapabilityEntry> &cmc, double frequency_Hz);

/// Nothing in the report is stated with a smaller U than the laboratory's CMC (ILAC-P14:09/2020,
/// 5.4); unchanged without entries. Rows that are stated outside the laboratory's scope are a
/// caution (CER-007). `response` is what the report is of.
void holdToCapability(const std::vector<CapabilityEntry> &cmc, const ResponseResult &response,
    UncertaintyReport &report);

} // namespace dyncal
