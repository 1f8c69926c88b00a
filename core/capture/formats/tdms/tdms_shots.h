// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/capture/formats/tdms/tdms_container.h"

#include <vector>

namespace dyncal {

/// Channels that were recorded together.
struct TdmsShotPlan
{
    std::string name; ///< distinguishes it from other shots; empty with one shot
    std::vector<const TdmsObject *> channels;
};

struct TdmsShots
{
    std::vector<TdmsShotPlan> shots;
    Findings findings; ///< about what was left out or assumed
};

/// Puts the channels of a file into shots. Logs of SignalExpress: the groups that are not thinned
/// out (DecimationLevel 0), one shot per logged interval (IntervalIndex). Other files: one shot per
/// group if several groups have the same channels, else one shot of all channels.
TdmsShots tdmsShots(const TdmsContents &contents, const std::string &path);

} // namespace dyncal
