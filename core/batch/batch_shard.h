// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>

namespace dyncal {

/// One of `count` parts of a plan: every count-th sensor, so that the parts take about as long.
/// What is computed of a sensor does not depend on it.
struct BatchShard
{
    std::size_t number = 1; ///< from 1
    std::size_t count = 1;

    bool holds(std::size_t position) const { return position % count == number - 1; }
};

/// "3/7"; "" is the whole. Fails (Usage) unless both are whole numbers with 1 <= K <= N <= 1e6.
Result<BatchShard> parseShard(const std::string &text);

} // namespace dyncal
