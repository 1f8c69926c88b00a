// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// ASCII letters only; everything else stays.
std::string lowerCase(std::string text);

/// Without the blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

/// "a, b, c": the first `most` of them, and "..." where there are more.
std::string commaList(const std::vector<std::string> &texts,
    std::size_t most = std::numeric_limits<std::size_t>::max());

} // namespace dyncal
