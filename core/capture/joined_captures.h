// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

namespace dyncal {

/// The shots of `first`, then those of `second`, with their inputs and findings numbered on. The
/// tube and the instruments are those of the first that describes them, never a mixture of two. A
/// sensor id that stands for two different cards becomes two ("dut", "dut (2)"), so that every
/// channel keeps its own card.
CaptureSet joinedCaptures(CaptureSet first, CaptureSet second);

} // namespace dyncal
