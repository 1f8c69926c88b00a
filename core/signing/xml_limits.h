// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace dyncal {

/// Bytes of the largest XML document that is signed or checked.
inline constexpr std::size_t kMostXmlBytes = 32U * 1024U * 1024U;

} // namespace dyncal
