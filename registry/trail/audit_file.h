// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "registry/trail/audit_entry.h"

#include <nlohmann/json.hpp>

namespace dyncal {

/// A line of audit.jsonl. Entries about other certificates are closed: a customer is given their
/// hashes, by which the chain can be followed, and not what they say.
struct AuditLine
{
    Index sequence = 0;
    std::string previous;
    std::string content; ///< contentSha256()
    std::string sha256;
    std::optional<AuditEntry> entry; ///< of an open line
};

/// All of an entry as JSON, by the names of its members.
nlohmann::json entryJson(const AuditEntry &entry);

/// audit.jsonl: one JSON object a line, keys sorted. Open are the entries of `object`.
std::string auditText(const std::vector<AuditEntry> &entries, const std::string &object);

/// Reads it back. Fails (FileUnreadable), with the number of the line, where it is no such file.
Result<std::vector<AuditLine>> parseAudit(const std::string &text);

/// Number (from 1) of the first line that does not follow from the one before or whose hashes are
/// not those of what it says; empty for an unbroken chain.
std::optional<Index> firstBrokenLine(const std::vector<AuditLine> &lines);

} // namespace dyncal
