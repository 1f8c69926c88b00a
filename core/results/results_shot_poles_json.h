// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// Uncertainty, then each shot and level; part of the section "model".
void addShotPoles(JsonRecord &section, const ResultsContext &context);

} // namespace dyncal
