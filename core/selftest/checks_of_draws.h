// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stage "monte_carlo_of_the_chain": the sum of four even distributions (JCGM 101, 9.2), whose
/// distribution is known in closed form, and the tolerance of a validation (7.9.2).
std::vector<CheckSpec> checksOfDraws();

} // namespace dyncal
