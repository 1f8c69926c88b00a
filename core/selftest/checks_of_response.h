// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stage "response": the second-order sensor in closed form, from its record and from its
/// poles.
std::vector<CheckSpec> checksOfResponse();

} // namespace dyncal
