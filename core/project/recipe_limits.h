// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

namespace dyncal {

inline constexpr Index kMostShots = 100000; ///< largest number of entries in a list per shot

} // namespace dyncal
