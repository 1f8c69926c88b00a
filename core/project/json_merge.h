// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/strict_json.h"

#include <string_view>

namespace dyncal {

/// Internal to core/project: puts one recipe document over another. Objects are joined key by key,
/// any other value of `upper` replaces the one below. `key` is what both stand under: below
/// "channels" a role alone ("dut") is the "role" of an object, so that neither loses what the other
/// says of the channel.
void putOver(Json &lower, const Json &upper, std::string_view key = {});

} // namespace dyncal
