// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/project_state.h"

#include <functional>
#include <string>

namespace dyncal {

/// Whether `path` is one of the recordings: writing there would destroy measured data.
bool isRecordingOf(const CaptureSet &set, const std::string &path);

/// Removes settings of files and channels that the recordings do not have: a recipe may not name
/// them.
void forgetMissingNames(ImportSettings &settings, const CaptureSet &set);

/// The recordings without the shots for which `isOut` is true, and without files that only those
/// used.
CaptureSet withoutShots(CaptureSet set, const std::function<bool(const Shot &)> &isOut);

/// The job without shot `number` (from 1): the numbers of later shots fall by one, also in the
/// recipe's exclusions, acknowledgements, starts and arrivals.
ProjectState withoutShot(const ProjectState &state, Index number);

/// Includes shot `number` (no reason) or excludes it, for the reason that the certificate prints.
void setShotExcluded(
    ImportSettings &settings, Index number, const std::optional<std::string> &reason);

} // namespace dyncal
