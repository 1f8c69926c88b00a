// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"

namespace dyncal {

/// What the rows say: withheld ones (RSP-003, RSP-004, RSP-005), and one that differs from the
/// model by more than noise and bounds allow (RSP-001).
void judgeRows(ResponseResult &result);

/// WIN-005: frequencies below the band. A list is computed as given; below the band the values
/// depend on the plateau by which the records are continued, not on recorded samples.
void reportBelowBand(ResponseResult &result);

} // namespace dyncal
