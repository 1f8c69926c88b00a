// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/trail/audit_entry.h"

#include "core/base/content_hash.h"
#include "core/base/json_text.h"
#include "core/base/version.h"

namespace dyncal {

std::string programText()
{
    return std::string("dyncal ").append(versionText()).append(" (build ").append(buildText())
        + ')';
}

const std::string kNoEntry(kSha256Digits, '0');

std::string contentSha256(const AuditEntry &entry)
{
    return sha256Hex(std::string_view(jsonLine({{"utc", entry.utc}, {"who", entry.who},
        {"action", entry.action}, {"object", entry.object}, {"before", entry.before},
        {"after", entry.after}, {"reason", entry.reason}, {"program", entry.program}})));
}

std::string entrySha256(
    const std::string &previous, Index sequence, const std::string &contentSha256)
{
    return sha256Hex(
        std::string_view(previous + ' ' + std::to_string(sequence) + ' ' + contentSha256));
}

AuditEntry chained(AuditEntry entry, const AuditEntry *last)
{
    entry.sequence = last ? last->sequence + 1 : 1;
    entry.previous = last ? last->sha256 : kNoEntry;
    entry.sha256 = entrySha256(entry.previous, entry.sequence, contentSha256(entry));
    return entry;
}

std::optional<Index> firstBreak(const std::vector<AuditEntry> &entries)
{
    const AuditEntry *last = nullptr;
    for (const AuditEntry &entry : entries) {
        if (chained(entry, last) != entry)
            return entry.sequence;
        last = &entry;
    }
    return std::nullopt;
}

} // namespace dyncal
