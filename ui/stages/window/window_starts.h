// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// One start per shot of a set of `shots`, as the last run used it, on each record's own axis;
/// shots without a response (excluded) get the first one's. `window` has a response.
std::vector<double> usedStarts(const WindowResult &window, std::size_t shots);

/// Sets typed starts, one per shot; stretches left out stay where they are in the records.
void typeStarts(
    WindowSettings &settings, const std::vector<double> &starts_s, const WindowResult &window);

/// Has the starts detected again; stretches left out stay where they are in the records.
void detectStartsAgain(WindowSettings &settings, const CalibrationResults &results);

} // namespace dyncal
