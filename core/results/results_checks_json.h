// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// Adds `checks`: every comparison of two independent ways to one quantity, with the smallest fault
/// that it could see, or why it could not be made. Internal to core/results.
void addChecks(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal
