// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/decomposition/component_result.h"
#include "core/signal/signal_settings.h"

namespace dyncal {

/// PCA-002 (not white), PCA-003 (a resonance of the average is left), PCA-004 (one shot dominates).
Findings residualFindings(const ComponentResult &result, const SpectrumSettings &spectrum);

} // namespace dyncal
