// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stages "decomposition" and "model": a second-order sensor whose poles are known, with the
/// singular values of an independent decomposition.
std::vector<CheckSpec> checksOfRealization();

} // namespace dyncal
