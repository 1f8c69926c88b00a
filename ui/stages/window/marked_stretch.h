// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/interval.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"

#include <string>
#include <vector>

namespace dyncal {

/// A stretch as the operator marks it: one span and one reason, in one shot or in several. The
/// recipe has an entry for every shot.
struct MarkedStretch
{
    Interval span_s; ///< relative to the start
    std::vector<Index> shots; ///< numbers from 1, ascending
    std::string reason;

    bool operator==(const MarkedStretch &) const = default;
};

/// The recipe's entries; those of the same span and reason become one, at the place of the first.
std::vector<MarkedStretch> markedStretches(const std::vector<ExcludedStretch> &entries);

/// The entries of the recipe for these.
std::vector<ExcludedStretch> excludedStretches(const std::vector<MarkedStretch> &stretches);

/// Keeps the marked stretches where they are in the records when the starts of the shots move.
/// `later_s`: by shot, new start minus old start.
void keepInRecord(std::vector<ExcludedStretch> &entries, const std::vector<double> &later_s);

/// Why a stretch cannot be applied, or (None) that it can.
enum class StretchFault { None, NoReason, EndBeforeBegin, OutsideWindow };
/// Judged by the windows of its shots; shots without a window (not used) are passed over.
StretchFault faultOf(const MarkedStretch &stretch, const std::vector<WindowedResponse> &responses);

/// The part of a span that lies in the windows of its shots, since the mouse may mark more; the
/// whole span if no part of it does.
Interval withinWindows(Interval span_s, const std::vector<Index> &shots,
    const std::vector<WindowedResponse> &responses);

} // namespace dyncal
