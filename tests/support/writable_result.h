// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <memory>
#include <utility>

namespace dyncal::testing {

/// Replaces a result by a copy that may be written to; by an empty one if there was none.
template <typename T>
T &writable(std::shared_ptr<const T> &result)
{
    auto copy = result ? std::make_shared<T>(*result) : std::make_shared<T>();
    T &written = *copy;
    result = std::move(copy);
    return written;
}

} // namespace dyncal::testing
