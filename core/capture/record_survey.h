// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/raw_samples.h"

namespace dyncal {

/// Equal samples in a row.
struct EqualRun
{
    Index begin = -1;
    Index count = 0;
};

/// What one pass over the raw values of a record finds.
struct RecordSurvey
{
    Index size = 0;
    bool readable = true; ///< false: the samples could not be read to their end
    double lowest = 0.0; ///< of the valid samples; both 0 if there are none
    double highest = 0.0;
    Index invalid = 0;
    Index firstInvalid = -1;
    Index lastInvalid = -1;
    EqualRun top; ///< the longest run at the highest value
    EqualRun bottom; ///< the longest run at the lowest value
    double sd = 0.0; ///< standard deviation in codes; only of integer samples

    bool isConstant() const { return lowest == highest; }
};

/// Surveys the whole record in one pass, block by block where the samples are in a file.
RecordSurvey surveyRecord(const RawSamples &samples);

} // namespace dyncal
