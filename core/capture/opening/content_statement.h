// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace dyncal {

/// The SHA-256 that each capture states of all that it says (docs/method/captures.md), in the order
/// of the paths; empty for one that states none, as those of older versions and other programs:
/// nothing protects their texts.
Result<std::vector<std::string>> statedContentHashes(const std::vector<std::string> &paths);

} // namespace dyncal
