// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace dyncal {

/// ".dyncal-" and 32 hexadecimal digits that nobody can foresee: nobody can plant a file under that
/// name beforehand. The only use of chance in core; no number depends on it.
std::string newTemporaryName();

/// Whether a name has this form.
bool isTemporaryName(std::string_view name);

/// For tests: names from this function instead; an empty one restores random names.
void setTemporaryNames(std::function<std::string()> names);

} // namespace dyncal
