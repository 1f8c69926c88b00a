// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stages "captures" and "arrivals", and the reading of files: values by one formula, events at
/// a known sample, a capture written and read back, the hash that FIPS 180-4 gives.
std::vector<CheckSpec> checksOfRecords();

} // namespace dyncal
