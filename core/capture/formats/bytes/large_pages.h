// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace dyncal {

constexpr std::size_t kLargePage = std::size_t(2) << 20;

/// Asks the system for large pages behind memory that is about to be filled: handing out small ones
/// one by one takes as long as reading a file from the cache. Only a hint.
void preferLargePages(void *memory, std::size_t bytes);

} // namespace dyncal
