// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms_cursor.h"

namespace dyncal {

bool TdmsCursor::copy(std::byte *target, std::size_t bytes)
{
    constexpr std::uint64_t kWindow = 32 * 1024;
    if (remaining() < bytes)
        return false;
    const std::uint64_t windowEnd = m_windowBegin + m_window.size();
    if (m_position < m_windowBegin || m_position + bytes > windowEnd) {
        if (bytes > kWindow) {
            const bool done = m_file.read(m_position, bytes, target);
            m_position += bytes;
            return done;
        }
        m_windowBegin = m_position;
        m_window.resize(static_cast<std::size_t>(std::min(kWindow, m_file.size() - m_position)));
        if (!m_file.read(m_windowBegin, m_window.size(), m_window.data())) {
            m_window.clear();
            return false;
        }
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
