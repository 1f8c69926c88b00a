// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace dyncal {

/// The SHA-256 of all its content that each capture states (docs/method/captures.md), in the order
/// of the paths; empty for one that states none (older versions, other programs): changes of its
/// texts cannot be noticed.
Result<std::vector<std::string>> statedContentHashes(const std::vector<std::string> &paths);

} // namespace dyncal
