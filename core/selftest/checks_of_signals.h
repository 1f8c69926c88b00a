// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stages "window", "spectrum", "components" and "model_input": a second-order step in closed
/// form, a cosine of whole periods, components that were put together, and what a filter must pass.
std::vector<CheckSpec> checksOfSignals();

} // namespace dyncal
