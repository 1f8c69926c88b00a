// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/channel.h"
#include "core/signal/window_bands.h"

#include <optional>

namespace dyncal {

/// Whether a record stands still at one value, in or behind the response window, for longer than
/// the noise of its baseline explains (stuck_values.h): cut off at limits that the file does not
/// state, or stuck. Looked at are the window and as many samples behind it, up to the first that is
/// not finite.
struct Standstill
{
    Index begin = 0; ///< sample of the record at which the longest time begins
    Index longest = 0; ///< samples
    double value = 0.0; ///< in the channel's unit
    double windowShare = 0.0; ///< of the window's samples
    /// The record froze inside the range of the response, so close behind the window that an
    /// automatic end lies where it froze and not where the plateau ends.
    bool setsTheEnd = false;
};

/// The standstill that takes more than a fifth of the window, or of what was looked at; empty if
/// there is none. The channel's values in the window are finite.
std::optional<Standstill> standstill(const Channel &channel, const WindowBands &bands);

/// CAP-007: a fifth of the window is still, or `endIsSearched` and the record froze there. Empty if
/// the response can be used.
std::optional<Error> blockingStandstill(
    const Channel &channel, Index shot, const Standstill &found, bool endIsSearched);

/// CAP-007, a caution: the record stands still behind a response that can be used.
Finding standstillBehind(const Channel &channel, Index shot, const Standstill &found);

} // namespace dyncal
