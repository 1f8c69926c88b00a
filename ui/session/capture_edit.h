// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/project_state.h"

#include <functional>
#include <string>

namespace dyncal {

/// The recordings of `first` followed by those of `second`; shot numbers of the second's findings
/// are moved on. Tube and sensor data of the first win.
CaptureSet joinedCaptures(CaptureSet first, const CaptureSet &second);

/// Whether this name is one of a recording's: to write there would destroy what was measured.
bool isRecordingOf(const CaptureSet &set, const std::string &path);

/// Takes out what names files and channels that the recordings do not have: a recipe may not.
void forgetMissingNames(ImportSettings &settings, const CaptureSet &set);

/// The recordings without the shots for which `isOut` says so, and without files that only they
/// used.
CaptureSet withoutShots(CaptureSet set, const std::function<bool(const Shot &)> &isOut);

/// The job without shot `number` (from 1): later shots move up by one, and every part of the
/// recipe that goes by shot number moves with them.
ProjectState withoutShot(const ProjectState &state, Index number);

/// Takes shot `number` in (no reason) or out, for the reason that the certificate prints.
void setShotExcluded(
    ImportSettings &settings, Index number, const std::optional<std::string> &reason);

} // namespace dyncal
