// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/project_state.h"

namespace dyncal {

/// The recordings of `first` followed by those of `second`; shot numbers of the second's findings
/// are moved on. Tube and sensor data of the first win.
CaptureSet joinedCaptures(const CaptureSet &first, const CaptureSet &second);

/// The job without shot `number` (from 1): later shots move up by one, and every part of the
/// recipe that goes by shot number moves with them.
ProjectState withoutShot(const ProjectState &state, Index number);

} // namespace dyncal
