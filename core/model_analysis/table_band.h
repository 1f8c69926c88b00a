// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"
#include "core/reference/reference_sensitivity.h"

namespace dyncal {

/// The band ends where a table does, of the chain or of a reference transducer; `why` says which.
/// Findings, both cautions: RSP-007 where the table and the band of the records have nothing in
/// common, so that no response can be stated; RSP-006 where two rows within the band are more than
/// a decade apart. A straight line over log f joins them, and what it misses is in no uncertainty:
/// responses of amplifiers and transducers are listed in steps of a third of an octave to a decade.
void endByTable(const ReferenceSensitivity &table, BandEnd why, ResponseResult &result);

} // namespace dyncal
