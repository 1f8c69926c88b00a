// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"
#include "core/reference/reference_sensitivity.h"

namespace dyncal {

/// The band ends where a table does, of the chain or of a reference transducer; `why` says which.
/// Findings, all cautions: RSP-007 where the table and the band of the records have nothing in
/// common, so that no response can be stated; RSP-006 where two rows within the band are more than
/// a decade apart. A straight line over log f joins them, and what it misses is in no uncertainty:
/// responses of amplifiers and transducers are listed in steps of a third of an octave to a decade.
/// RSP-008 where it does not fit the record, as frequencies in kHz make it: it ends below a tenth
/// of what the model is flat to within 10 %, or the chain's is off by more than 15 % below half of
/// that, where chain and sensor together are flat.
void endByTable(const ReferenceSensitivity &table, BandEnd why, ResponseResult &result);

} // namespace dyncal
