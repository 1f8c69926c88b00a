// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The correction of recordings and the rounding of the certificate.
std::vector<CheckSpec> checksOfCorrection();

} // namespace dyncal
