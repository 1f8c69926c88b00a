// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <memory>
#include <utility>

namespace dyncal::testing {

/// Puts a copy in the place of a result, an empty one where there was none, and lets it be
/// written to.
template <typename T>
T &writable(std::shared_ptr<const T> &result)
{
    auto copy = result ? std::make_shared<T>(*result) : std::make_shared<T>();
    T &written = *copy;
    result = std::move(copy);
    return written;
}

} // namespace dyncal::testing
