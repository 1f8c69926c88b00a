// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/capture/check_settings.h"
#include "core/reference/comparison_settings.h"
#include "core/reference/reference_sensitivity.h"
#include "core/signal/response_window.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A reference transducer beside the DUT: what it is, and what it recorded.
struct ReferenceRecords
{
    ReferenceSensitivity sensitivity;
    std::vector<WindowedResponse> responses = {}; ///< of each shot of the DUT's, over the same time
    std::string channel = {};
    std::string sourceSha256 = {}; ///< of the file that `sensitivity` comes from; empty of a model
    std::string certificate = {}; ///< its number, where the file states one
    std::string due = {}; ///< date until which it holds, as the file states it
    double delay_s = 0.0; ///< see ComparisonSettings
    std::optional<double> u_delay_s = std::nullopt;
    double correlationWithStep = 0.0;

    const WindowedResponse *ofShot(Index shot) const; ///< null without one
};

/// Sensitivity and records of the reference transducer for the shots of `duts`. Fails (Usage)
/// without a source or model or with both, on a malformed source, on an uncertainty of 0 and on
/// another unit than that of its channel; (FileUnreadable) where the source was not read;
/// (DataBlocked) on a source with another hash than the recipe's, a shot without the channel, and
/// as cutAlongside().
Result<ReferenceRecords> referenceRecords(const CaptureSet &set,
    const std::vector<WindowedResponse> &duts, const ComparisonSettings &settings,
    const CheckSettings &checks);

} // namespace dyncal
