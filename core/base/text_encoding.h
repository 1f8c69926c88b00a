// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <string_view>

namespace dyncal {

// Texts of instruments and spreadsheets are UTF-8, UTF-16 or Windows-1252, and seldom say which.

/// What a text in UTF-8 may begin with.
inline constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// Order of the two bytes of UTF-16.
enum class ByteOrder { None, LittleEndian, BigEndian };

/// UTF-16 is recognised by its mark, or by two ASCII characters at the beginning; None is not
/// UTF-16.
ByteOrder byteOrderOf(std::string_view bytes);

/// UTF-16 as UTF-8, without the mark. A lone half of a surrogate pair becomes three bytes that are
/// no valid UTF-8.
std::string fromUtf16(std::string_view bytes, bool bigEndian);

bool isUtf8(std::string_view text);

/// UTF-8 of a name or unit: left alone if it is valid UTF-8, otherwise taken as Windows-1252.
std::string utf8Text(std::string_view text);

} // namespace dyncal
