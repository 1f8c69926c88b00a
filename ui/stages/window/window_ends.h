// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "core/signal/signal_settings.h"

#include <QString>

#include <optional>

namespace dyncal {

// The window's end as the operator chooses it: one for all shots, or one for each.

/// Whether each shot has an end of its own that is set for it, not the common one.
bool hasOwnEnds(const WindowSettings &settings);

/// Gives each of `shots` shots the common end as its own; it can be moved alone from then on.
void giveOwnEnds(WindowSettings &settings, std::size_t shots);

/// Gives all shots the end of `shot` (from 1), as the common one.
void giveCommonEnd(WindowSettings &settings, Index shot);

/// Sets the end of `shot` (from 1), or the common one if that is what holds; not the plateau any
/// more.
void typeEnd(WindowSettings &settings, Index shot, const Auto<double> &end_s);

/// The last moment of a record after the start of its response, and which shot's record it is.
struct RecordEnd
{
    double end_s;
    Index shot;
};

/// How far the end of `shot` may go: to the end of its own record, or, for the common end, of the
/// record that is over first. Empty without results.
std::optional<RecordEnd> lastEnd(
    const WindowSettings &settings, const CalibrationResults &results, Index shot);

/// For whom the end holds that is shown with `shot`, whose plateau is over before it, and whose
/// record ends there.
QString endText(const WindowSettings &settings, const CalibrationResults &results, Index shot);

} // namespace dyncal
