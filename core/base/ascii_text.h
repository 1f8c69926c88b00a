// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>

namespace dyncal {

/// ASCII letters only; everything else stays.
std::string lowerCase(std::string text);

/// Without the blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

} // namespace dyncal
