// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// Name of the list in the folder that it describes.
inline constexpr const char *kWrittenList = "written.json";
inline constexpr std::size_t kLongestList = 16U << 20U; ///< bytes of it that are read

/// One file that a program wrote into a folder.
struct WrittenFile
{
    std::string file; ///< relative to the folder, '/' between its parts
    std::string by; ///< what wrote it: "run", "export"
    std::string sha256;

    bool operator==(const WrittenFile &) const = default;
};

using WrittenList = std::vector<WrittenFile>;

/// The entry of a file; null if it is not listed.
const WrittenFile *listed(const WrittenList &list, const std::string &file);

/// UTF-8 JSON, schema "dyncal-written/1", sorted by file, two-space indent, LF.
std::string writtenListText(WrittenList list);

/// Empty if the text is no such list, or holds an impossible name: absolute, with "." or "..", an
/// empty part or a control character.
std::optional<WrittenList> parseWrittenList(std::string_view text);

} // namespace dyncal
