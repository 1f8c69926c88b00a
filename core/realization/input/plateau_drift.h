// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// Whether the level of most responses changes between `from_s` and the end of their windows: the
/// straight line through 32 means of that stretch falls or rises by more than six of its standard
/// uncertainties (those of the means about the line, or of as long means of the noise before the
/// start where they scatter more: it may be coloured), and by at least a thousandth of the level.
/// False for a stretch of fewer than 320 samples. No source: docs/method/model-input.md.
bool levelsDriftBehind(const std::vector<WindowedResponse> &responses, double from_s);

} // namespace dyncal
