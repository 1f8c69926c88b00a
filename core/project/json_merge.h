// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/strict_json.h"

#include <string_view>

namespace dyncal {

/// Internal to core/project: puts one recipe document over another. Objects are joined key by key,
/// any other value of `upper` replaces the one below. `key` is the key of both: under "channels" a
/// role alone ("dut") counts as an object with that "role", so that the other settings of the
/// channel are kept.
void putOver(Json &lower, const Json &upper, std::string_view key = {});

} // namespace dyncal
