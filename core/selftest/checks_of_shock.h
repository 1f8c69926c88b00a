// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stages "expected_shock" and "shock": exact fractions at M = 2, table 4.2 of the thesis, the
/// published speed of sound of moist air, and inputs of which the velocity follows by one division.
std::vector<CheckSpec> checksOfShock();

} // namespace dyncal
