// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/file_samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace dyncal {

/// Takes numbers and texts from the bytes of a header, in either byte order. Beyond their end every
/// value is zero and ok() stays false, so that a header is read in one go and checked once.
class ByteReader
{
public:
    explicit ByteReader(std::span<const std::byte> bytes, std::endian order = std::endian::little)
        : m_bytes(bytes)
        , m_order(order)
    {
    }

    bool ok() const { return m_ok; }
    std::size_t position() const { return m_position; }
    std::size_t remaining() const { return m_bytes.size() - m_position; }

    /// Going to the end is allowed, beyond is not.
    void seek(std::size_t position)
    {
        m_ok = m_ok && position <= m_bytes.size();
        m_position = std::min(position, m_bytes.size());
    }
    void skip(std::size_t bytes)
    {
        const bool there = bytes <= remaining();
        m_ok = m_ok && there;
        m_position = there ? m_position + bytes : m_bytes.size();
    }

    template <typename T>
    T next()
    {
        static_assert(std::is_arithmetic_v<T>);
        std::array<std::byte, sizeof(T)> raw{};
        const std::span<const std::byte> source = take(sizeof(T));
        if (source.size() != sizeof(T))
            return T{};
        std::copy(source.begin(), source.end(), raw.begin());
        if (m_order != std::endian::native)
            std::reverse(raw.begin(), raw.end());
        return std::bit_cast<T>(raw);
    }

    template <typename T>
    T at(std::size_t position)
    {
        seek(position);
        return next<T>();
    }

    /// The next bytes; empty if there are not that many.
    std::span<const std::byte> take(std::size_t bytes)
    {
        const std::size_t begin = m_position;
        skip(bytes);
        return m_position - begin == bytes ? m_bytes.subspan(begin, bytes)
                                           : std::span<const std::byte>();
    }

    /// A field of that many characters, up to its first NUL and without blanks at both ends.
    std::string text(std::size_t bytes)
    {
        const std::span<const std::byte> field = take(bytes);
        std::string text;
        for (const std::byte character : field) {
            if (character == std::byte{0})
                break;
            text += std::to_integer<char>(character);
        }
        const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
        while (!text.empty() && isBlank(text.back()))
            text.pop_back();
        text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), isBlank));
        return text;
    }

private:
    std::span<const std::byte> m_bytes;
    std::endian m_order;
    std::size_t m_position = 0;
    bool m_ok = true;
};

/// The bytes [offset, offset + count) of a file, fewer where it ends before; none if it cannot be
/// read. `count` is the caller's own bound, never what a header claims.
inline std::vector<std::byte> bytesAt(
    const SampleFile &file, std::uint64_t offset, std::size_t count)
{
    const std::uint64_t there = offset < file.size() ? file.size() - offset : 0;
    std::vector<std::byte> bytes(
        static_cast<std::size_t>(std::min(there, static_cast<std::uint64_t>(count))));
    if (!file.read(offset, bytes.size(), bytes.data()))
        bytes.clear();
    return bytes;
}

} // namespace dyncal
