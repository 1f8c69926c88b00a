// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/xml/xml_file.h"

#include "core/xml/xml_limits.h"

#include <fstream>

namespace dyncal {

Result<std::string> xmlFileBytes(const std::string &path)
{
    constexpr std::size_t kChunkBytes = std::size_t(64) << 10U;
    std::ifstream stream(path, std::ios::binary);
    std::string bytes, chunk(kChunkBytes, '\0');
    while (stream && bytes.size() <= kMostXmlBytes) {
        stream.read(chunk.data(), std::ssize(chunk));
        bytes.append(chunk, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.is_open() && !stream.bad())
        return bytes;
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "%1 cannot be read; check the path and the rights of the file."),
            {path}});
}

} // namespace dyncal
