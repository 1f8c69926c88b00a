// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/file_samples.h"

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace dyncal {

/// Reads the numbers and texts of lead-ins and metadata one after the other, through a small window
/// of the file: small segments do not cost a system call each, and no claim of a header is
/// allocated. At the end set by limit() every call returns false and does not move.
class TdmsCursor
{
public:
    explicit TdmsCursor(const SampleFile &file)
        : m_file(file)
        , m_end(file.size())
    {
    }

    void moveTo(std::uint64_t position) { m_position = position; }
    void limit(std::uint64_t end) { m_end = std::min(end, m_file.size()); }
    void setByteOrder(std::endian order) { m_order = order; }
    std::endian byteOrder() const { return m_order; }

    std::uint64_t position() const { return m_position; }
    std::uint64_t remaining() const { return m_end > m_position ? m_end - m_position : 0; }

    template <std::unsigned_integral T>
    bool number(T &value)
    {
        std::byte bytes[sizeof(T)];
        if (!copy(bytes, sizeof(T)))
            return false;
        value = 0;
        for (std::size_t i = 0; i < sizeof(T); ++i) {
            const std::size_t place = m_order == std::endian::little ? i : sizeof(T) - 1 - i;
            value = static_cast<T>(
                value | static_cast<T>(std::to_integer<T>(bytes[i]) << (8 * place)));
        }
        return true;
    }

    /// Length and bytes; false also for a text longer than kLongestText.
    bool text(std::string &value);
    bool skip(std::uint64_t bytes);

    static constexpr std::uint32_t kLongestText = 1 << 24;

private:
    bool copy(std::byte *target, std::size_t bytes);
    void moveWindow();

    const SampleFile &m_file;
    std::vector<std::byte> m_window;
    std::uint64_t m_windowBegin = 0;
    std::uint64_t m_position = 0;
    std::uint64_t m_end;
    std::endian m_order = std::endian::little;
};

} // namespace dyncal
