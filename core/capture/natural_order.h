// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string_view>

namespace dyncal {

/// Whether `a` comes before `b` the way people count: "shot 9" before "shot 10". Runs of digits
/// compare as numbers, everything else byte by byte; a strict total order.
bool naturalLess(std::string_view a, std::string_view b);

} // namespace dyncal
