// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_cursor.h"

namespace dyncal {

void TdmsCursor::moveWindow()
{
    constexpr std::uint64_t kLeast = 1024;
    constexpr std::uint64_t kMost = 32 * 1024;
    // Large segments lie far apart, and only their first bytes are needed; small ones are read
    // together.
    const std::uint64_t size = m_window.size();
    const bool near = m_position >= m_windowBegin && m_position <= m_windowBegin + 2 * size;
    const std::uint64_t wanted = near ? std::clamp(2 * size, kLeast, kMost) : kLeast;
    m_windowBegin = m_position;
    m_window.resize(static_cast<std::size_t>(std::min(wanted, m_file.size() - m_position)));
    if (!m_file.read(m_windowBegin, m_window.size(), m_window.data()))
        m_window.clear();
}

bool TdmsCursor::copy(std::byte *target, std::size_t bytes)
{
    constexpr std::size_t kLarge = 512;
    if (remaining() < bytes)
        return false;
    if (bytes > kLarge) {
        const bool done = m_file.read(m_position, bytes, target);
        m_position += bytes;
        return done;
    }
    if (m_position < m_windowBegin || m_position + bytes > m_windowBegin + m_window.size()) {
        moveWindow();
        if (m_window.size() < bytes)
            return false;
    }
    std::memcpy(target, m_window.data() + (m_position - m_windowBegin), bytes);
    m_position += bytes;
    return true;
}

bool TdmsCursor::text(std::string &value)
{
    std::uint32_t length = 0;
    if (!number(length) || length > kLongestText || remaining() < length)
        return false;
    value.resize(length);
    return length == 0 || copy(reinterpret_cast<std::byte *>(value.data()), length);
}

bool TdmsCursor::skip(std::uint64_t bytes)
{
    if (remaining() < bytes)
        return false;
    m_position += bytes;
    return true;
}

} // namespace dyncal
