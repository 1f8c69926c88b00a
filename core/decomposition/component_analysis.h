// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/decomposition/component_result.h"
#include "core/decomposition/component_settings.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"

#include <vector>

namespace dyncal {

/// PCA, reconstructions, residuals and the average (thesis 3.7 step 4). Shots of a higher rate are
/// reduced to the lowest one; the common length is the shortest window. Usage error on
/// settings out of range.
Result<ComponentResult> analyseComponents(const std::vector<WindowedResponse> &responses,
    const ComponentSettings &settings, const SpectrumSettings &spectrum,
    const JobControl &control = {});

} // namespace dyncal
