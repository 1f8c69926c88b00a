// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>

namespace dyncal {

/// The key results as a short table for a person: natural frequency, damping, sensitivity, fit,
/// order and its reason, bands, findings. What was not computed is left out.
std::string runSummary(const PipelineOutcome &outcome, const Recipe &recipe);

} // namespace dyncal
