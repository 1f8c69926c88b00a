// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

namespace dyncal {

/// Stage results by the hash of what they were computed from, least recently used first out.
/// Makes undo instant. Thread-safe.
class ResultCache
{
public:
    explicit ResultCache(std::size_t capacity = 64)
        : m_capacity(capacity)
    {
    }

    template <typename T>
    std::shared_ptr<const T> find(const std::string &key)
    {
        return std::static_pointer_cast<const T>(findAny(key));
    }

    template <typename T>
    void store(const std::string &key, std::shared_ptr<const T> value)
    {
        storeAny(key, std::static_pointer_cast<const void>(std::move(value)));
    }

private:
    using Entry = std::pair<std::string, std::shared_ptr<const void>>;
    std::shared_ptr<const void> findAny(const std::string &key);
    void storeAny(const std::string &key, std::shared_ptr<const void> value);

    std::mutex m_mutex;
    std::size_t m_capacity;
    std::list<Entry> m_entries; ///< most recently used first
    std::unordered_map<std::string, std::list<Entry>::iterator> m_byKey;
};

} // namespace dyncal
