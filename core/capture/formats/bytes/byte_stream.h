// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace dyncal {

// Values as bytes between two copies of this process. A type takes part by a function
// `template <typename Stream> void transfer(Stream &stream, T &value)` that passes its fields to
// the stream, in one place for both directions.

/// Turns values into bytes.
class BytePacker
{
public:
    template <typename... T>
    void operator()(const T &...values)
    {
        (put(values), ...);
    }

    const std::vector<std::byte> &bytes() const { return m_bytes; }

private:
    void append(const void *data, std::size_t size)
    {
        const auto *begin = static_cast<const std::byte *>(data);
        m_bytes.insert(m_bytes.end(), begin, begin + size);
    }

    template <typename T>
    void put(const T &value)
    {
        if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
            append(&value, sizeof(T));
        else
            transfer(*this, const_cast<T &>(value)); // only read: transfer() serves both directions
    }
    void put(const std::string &text)
    {
        put(text.size());
        append(text.data(), text.size());
    }
    template <typename T>
    void put(const std::vector<T> &values)
    {
        put(values.size());
        for (const T &value : values)
            put(value);
    }
    template <typename T>
    void put(const std::map<std::string, T> &values)
    {
        put(values.size());
        for (const auto &[key, value] : values) {
            put(key);
            put(value);
        }
    }

    std::vector<std::byte> m_bytes;
};

/// Turns bytes into values and checks each: after the first that does not fit ok() is false and
/// values stay empty. Nothing longer than the bytes can hold is allocated.
class ByteUnpacker
{
public:
    explicit ByteUnpacker(std::span<const std::byte> bytes)
        : m_rest(bytes)
    {
    }

    template <typename... T>
    void operator()(T &...values)
    {
        (take(values), ...);
    }

    bool ok() const { return m_ok; }
    bool atEnd() const { return m_rest.empty(); }

private:
    bool extract(void *target, std::size_t size)
    {
        m_ok = m_ok && size <= m_rest.size();
        if (!m_ok)
            return false;
        if (size > 0)
            std::memcpy(target, m_rest.data(), size);
        m_rest = m_rest.subspan(size);
        return true;
    }

    /// Number of elements to come; each takes at least one byte.
    std::size_t takeCount()
    {
        std::size_t count = 0;
        take(count);
        m_ok = m_ok && count <= m_rest.size();
        return m_ok ? count : 0;
    }

    template <typename T>
    void take(T &value)
    {
        static_assert(!std::is_same_v<T, bool>, "not every byte is a bool");
        if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
            extract(&value, sizeof(T));
        else
            transfer(*this, value);
    }
    void take(std::string &text)
    {
        text.resize(takeCount());
        extract(text.data(), text.size());
    }
    template <typename T>
    void take(std::vector<T> &values)
    {
        const std::size_t count = takeCount();
        values.clear();
        for (std::size_t i = 0; i < count && m_ok; ++i)
            take(values.emplace_back());
    }
    template <typename T>
    void take(std::map<std::string, T> &values)
    {
        const std::size_t count = takeCount();
        values.clear();
        for (std::size_t i = 0; i < count && m_ok; ++i) {
            std::string key;
            take(key);
            take(values[key]);
        }
    }

    std::span<const std::byte> m_rest;
    bool m_ok = true;
};

} // namespace dyncal
