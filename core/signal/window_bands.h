// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/capture/channel.h"
#include "core/signal/signal_settings.h"

#include <optional>

namespace dyncal {

/// Samples [begin, end) of a record.
struct SampleRange
{
    Index begin = 0;
    Index end = 0;

    Index size() const { return end - begin; }
    bool overlaps(const SampleRange &other) const { return begin < other.end && other.begin < end; }
    bool operator==(const SampleRange &) const = default;
};

/// The parts of one record that the window stage uses.
struct WindowBands
{
    SampleRange window; ///< begins with the first sample of the response
    SampleRange baseline; ///< empty when nothing is subtracted
    SampleRange settle; ///< empty for the impulse treatment
};

inline constexpr Index kLeastBaseline = 50; ///< samples

/// Samples of the baseline and the window for a response that begins at sample `start` of the DUT's
/// record. Rules of the automatic bands: docs/method/window.md. `plateau_s` is the computed end of
/// the plateau after the start, needed only for an end "plateau". Fails (DataBlocked; Usage for
/// bands that make no sense); the message names the shot, what was found and what is possible.
Result<WindowBands> resolveBands(const Channel &channel, Index shot, Index start,
    const WindowSettings &settings, ResponseTreatment treatment, std::optional<double> plateau_s);

} // namespace dyncal
