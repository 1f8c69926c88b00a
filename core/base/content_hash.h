// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace dyncal {

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256Hex(std::span<const std::byte> bytes);
std::string sha256Hex(std::string_view text);

/// SHA-256 of a file's bytes, read in blocks; empty if it cannot be read.
std::string sha256OfFile(const std::string &path);

} // namespace dyncal
