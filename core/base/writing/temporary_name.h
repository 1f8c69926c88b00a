// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace dyncal {

/// ".dyncal-" and 32 hexadecimal digits that nobody can foresee: a file planted under the name of
/// a temporary one would have to be planted under all of them. The only use of chance in core; no
/// number depends on it.
std::string newTemporaryName();

/// Whether a name has this form.
bool isTemporaryName(std::string_view name);

/// Tests name the temporary files themselves; an empty function gives that up.
void setTemporaryNames(std::function<std::string()> names);

} // namespace dyncal
