// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace dyncal {

/// The characters of a file. Unlike std::string it does not write to its memory before the file is
/// read, and moving it does not move its characters.
class FileText
{
public:
    explicit FileText(std::size_t size);

    char *data() { return m_bytes.get(); }
    std::string_view view() const { return m_text; }
    void skip(std::size_t bytes) { m_text.remove_prefix(bytes); }

private:
    struct Free
    {
        void operator()(char *bytes) const { std::free(bytes); }
    };

    std::unique_ptr<char, Free> m_bytes;
    std::string_view m_text;
};

/// The whole file as UTF-8 or single-byte text: a byte order mark is removed, UTF-16 (with mark, or
/// beginning with two ASCII characters) is converted. Fails (CAP-018) if it cannot be read or has
/// more than 8 GiB.
Result<FileText> readTextFile(const std::string &path);

/// "%1 cannot be read" (CAP-018).
tl::unexpected<Error> unreadableText(const std::string &path);

/// Fails (CAP-018) for more bytes than a text may have, 8 GiB.
Result<void> checkTextSize(const std::string &path, std::uint64_t bytes);

/// As readTextFile(), for bytes in memory.
std::string textOfBytes(std::string bytes);

/// The beginning of a text file.
struct TextHead
{
    std::string text; ///< whole lines, unless the file is shorter or the first line longer
    std::string encoding; ///< "UTF-8", "UTF-16" or "Windows-1252"
    bool whole = false; ///< this is all of the file
};

/// At most `bytes` of the file. Fails as readTextFile.
Result<TextHead> readTextHead(const std::string &path, std::size_t bytes);

} // namespace dyncal
