// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/tdms/tdms_metadata.h"
#include "core/capture/formats/tdms/tdms_runs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dyncal {

/// The samples of a channel that belong to one scaler; a channel that is not DAQmx has one.
struct TdmsStream
{
    TdmsType type = TdmsType::Void;
    int bit = -1; ///< see TdmsScaler
    std::uint32_t scaleId = 0;
    TdmsRuns runs;
};

/// The file itself, a group or a channel.
struct TdmsObject
{
    TdmsPath path;
    TdmsProperties properties;
    std::optional<TdmsRawIndex> index; ///< the last one given
    TdmsType type = TdmsType::Void; ///< Void until an index was given
    std::vector<TdmsStream> streams; ///< none for values that are no samples (texts, time stamps)
    std::uint64_t count = 0; ///< values found
    double declared = 0.0; ///< values that the segments declare
};

/// The data of one segment.
struct TdmsRegion
{
    std::uint64_t begin = 0;
    std::uint64_t bytes = 0; ///< that are there
    std::uint64_t declaredBytes = 0; ///< at least `bytes`
    bool interleaved = false;
    bool bigEndian = false;
    bool ended = false; ///< the file ends within it or its writer did not close it
};

/// Adds the positions of a segment's samples to the streams of `objects` (those with data, in the
/// order of its list). An incomplete last chunk gives the values that exist. Nothing is added if
/// there is a problem.
tl::expected<void, TdmsProblem> placeTdmsRegion(
    const TdmsRegion &region, const std::vector<TdmsObject *> &objects);

} // namespace dyncal
