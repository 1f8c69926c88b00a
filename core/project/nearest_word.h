// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// Least number of insertions, deletions and replacements of bytes that turn `a` into `b`.
Index editDistance(std::string_view a, std::string_view b);

/// The known dotted key ("window.end_s") that the unknown one most likely means: the last part
/// counts most, so that a key in the wrong section is found too. Empty if `known` is empty.
std::string nearestKey(std::string_view unknown, const std::vector<std::string> &known);

} // namespace dyncal
