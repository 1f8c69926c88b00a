// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// What other responses are divided out or compared with: the chain ("response") and the reference
/// transducer ("reference_transducer"), by hand.
std::vector<CheckSpec> checksOfDivision();

} // namespace dyncal
