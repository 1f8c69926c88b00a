// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/record_survey.h"

namespace dyncal {

/// Whether a run of equal samples at an extreme of the record was cut off there, told from the
/// record alone because the converter's limits are not known. Something must have been moving:
/// - the noise is of more than 3 codes, so that no value repeats at an extreme by chance, or
/// - the value jumps into the run or out of it, by more than 1 % of the range, 6 standard
/// deviations
///   of the noise and 2 codes (a rounded peak arrives by one code), or
/// - the run is of 16 samples at least although the noise is larger than half a code.
/// A record without noise must jump on both sides, out of a movement: the plateau of a computed
/// step is flat by itself.
bool isCutOff(const RawSamples &samples, const RecordSurvey &survey, const EqualRun &run);

} // namespace dyncal
