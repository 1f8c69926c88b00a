// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/result_cache.h"

namespace dyncal {

std::shared_ptr<const void> ResultCache::findAny(const std::string &key)
{
    const std::scoped_lock lock(m_mutex);
    const auto found = m_byKey.find(key);
    if (found == m_byKey.end())
        return nullptr;
    m_entries.splice(m_entries.begin(), m_entries, found->second);
    return found->second->second;
}

void ResultCache::storeAny(const std::string &key, std::shared_ptr<const void> value)
{
    const std::scoped_lock lock(m_mutex);
    if (m_byKey.contains(key))
        return;
    m_entries.emplace_front(key, std::move(value));
    m_byKey[key] = m_entries.begin();
    if (m_entries.size() > m_capacity) {
        m_byKey.erase(m_entries.back().first);
        m_entries.pop_back();
    }
}

} // namespace dyncal
