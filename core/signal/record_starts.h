// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/capture_set.h"
#include "core/signal/start_detection.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Where the records of a set begin to move; found once, used by several stages.
struct RecordStarts
{
    /// By shot and by channel of the shot; empty = not looked for, or none found.
    std::vector<std::vector<std::optional<DetectedStart>>> shots;

    /// Of a channel of the set's shot `shot` (from 1); null = not looked for, or none found.
    const DetectedStart *of(const CaptureSet &set, Index shot, const Channel *channel) const;
};

/// Looks at the DUT and the first driven-side channel of every included shot, and at the channels
/// called by `others` (names or roles). `stepSigmas` as in detectStart(). Fails only when stopped.
Result<RecordStarts> detectStarts(const CaptureSet &set, const std::vector<std::string> &others,
    const JobControl &control = {}, double stepSigmas = kEventSigmas);

} // namespace dyncal
