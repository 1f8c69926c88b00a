// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/record_survey.h"

#include <functional>

namespace dyncal {

/// Scale of the values around a run: range, noise and step.
struct FlatTopScale
{
    double range = 0.0; ///< from the lowest to the highest value
    double noiseSd = 0.0;
    double codeSize = 0.0; ///< smallest step of the values; 0 = none known
};

/// Whether a run of equal values at an extreme was cut off there, judged by the values alone
/// because the converter's limits are not known. The signal must have been moving:
/// - the noise is of more than 3 codes, so that no value repeats at an extreme by chance, or
/// - the value jumps into the run or out of it, by more than 1 % of the range, 6 noiseSd and 2
///   codes (a rounded peak arrives by one code), or
/// - the run has at least 16 samples although the noise is larger than half a code.
/// Values without noise must jump on both sides, and move before and after: the plateau of a
/// computed step is flat by itself. `valueAt` answers for 0 <= i < size.
bool isCutOff(const std::function<double(Index)> &valueAt, Index size, const EqualRun &run,
    const FlatTopScale &scale);

/// The same for a whole record, whose noise is taken from its beginning.
bool isCutOff(const RawSamples &samples, const RecordSurvey &survey, const EqualRun &run);

} // namespace dyncal
