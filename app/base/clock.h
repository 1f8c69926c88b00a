// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>

namespace dyncal {

/// The time as ISO 8601 in UTC ("2026-01-31T12:00:00Z"): that of SOURCE_DATE_EPOCH if it is set, so
/// that a run can be repeated byte for byte. Fails (Usage) if that is not a whole number of
/// seconds. The only place of the program that reads a clock for what it writes.
Result<std::string> currentUtc();

} // namespace dyncal
