// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <functional>
#include <string>

namespace dyncal {

/// ISO 8601 with Z, from the program: the window reads no clock.
using CurrentUtc = std::function<Result<std::string>()>;

} // namespace dyncal
