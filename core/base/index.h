// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace dyncal {

/// Every count and position is signed (the type Eigen uses), so that differences never wrap.
using Index = std::ptrdiff_t;

} // namespace dyncal
