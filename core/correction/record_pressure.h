// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/interval.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/channel.h"
#include "core/correction/corrected_pressure.h"

#include <optional>

namespace dyncal {

/// What of a recording is corrected, and what is known of it beside.
struct RecordOptions
{
    std::optional<Interval> window_s = {}; ///< to be corrected, record's own axis; empty: all of it
    std::optional<Interval> quiet_s = {}; ///< without pressure; empty: before the detected start
    std::optional<double> beyond_Pa = {}; ///< what the pressure has beyond the band at most
};

/// The pressure behind one channel of one shot.
struct RecordPressure
{
    CorrectedPressure pressure;
    Interval quiet_s; ///< from which noise and level were taken
    double level = 0.0; ///< of the recording there, in its unit: taken off
    double noiseSd = 0.0; ///< of single samples there, in its unit
    Findings findings = {}; ///< COR-001: its drift before the pressure matters
};

/// Samples corrected at once at most.
inline constexpr Index kMostCorrected = 4'000'000;
/// Samples without pressure at least.
inline constexpr Index kFewestQuiet = 256;

/// Level and noise from the samples without pressure (the first three quarters before the start
/// where none are stated, the last 2^20 of longer ones), then correctedPressure(). `shot`, from 1,
/// is the number that messages name. Fails (Usage) where the channel's unit or rate is not the
/// filter's, where the window or the quiet stretch does not lie in the record, is too long or has
/// too few samples; (DataBlocked) where no start is found and none is stated, where samples are no
/// numbers, (FileUnreadable) where they cannot be read, and (Cancelled) when asked to stop.
Result<RecordPressure> recordPressure(const Channel &channel, Index shot,
    const CorrectionFilter &filter, const RecordOptions &options = {},
    const JobControl &control = {});

} // namespace dyncal
