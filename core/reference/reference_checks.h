// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/reference/reference_records.h"

namespace dyncal {

/// What makes the step that a reference transducer's records show another than the pressure's, by
/// shot. CMP-002: its level before the step or behind it moves by more than 0.25 % of the step over
/// half of its band, and that is more than noise. CMP-003: the step is negative. CMP-004: equal
/// values in a row at an extreme. All are cautions.
Findings judgeReferenceRecords(const ReferenceRecords &records, const CheckSettings &checks = {});

/// Whether a table begins above the frequencies of a record's level: above 1 over its length.
bool beginsAboveTheLevel(const ReferenceSensitivity &sensitivity, const WindowedResponse &response);

/// CMP-006 (caution): the step is taken from the records, the transducer's calibration begins above
/// the level's frequencies, and what its sensitivity may change below matters beside its u.
Findings judgeLevelOfReference(const ReferenceRecords &records);

} // namespace dyncal
