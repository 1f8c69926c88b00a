// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/capture_set.h"
#include "core/shock/shock_velocity.h"
#include "core/signal/record_starts.h"

#include <vector>

namespace dyncal {

/// CAP-010 for every shot whose DUT in the end wall feels the shock before a driven-side sensor
/// does. The shock passes the side sensor first, so the two channels look swapped. `arrivals` are
/// the starts of the DUTs, `starts` those of all records. Shots where one of the two has no arrival
/// are left out.
Findings checkChannelOrder(
    const CaptureSet &set, const std::vector<DutArrival> &arrivals, const RecordStarts &starts);

} // namespace dyncal
