// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stages "checks", "comparison" and "monte_carlo": quotients by hand, and the exact moments of
/// what is drawn.
std::vector<CheckSpec> checksOfWays();

} // namespace dyncal
