// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// One line of the audit trail: who did what when, to which row, and why. `before` and `after` are
/// the whole row as JSON on one line where the entry changed one, empty otherwise: so a row of the
/// registry is what the last entry of its object says, or it was changed past the trail.
struct AuditEntry
{
    Index sequence = 0; ///< from 1, without gaps
    std::string utc = {}; ///< ISO 8601 with Z
    std::string who = {};
    std::string action = {}; ///< "reserved", "issued", "accepted", ...
    std::string object = {}; ///< "certificate 17", "sensor Acme 5 17"
    std::string before = {};
    std::string after = {};
    std::string reason = {};
    std::string program = {}; ///< "dyncal 0.1.0 (build ...)"
    std::string previous = {}; ///< hash of the entry before; 64 zeros for the first
    std::string sha256 = {}; ///< entrySha256() of this one

    bool operator==(const AuditEntry &) const = default;
};

/// The program that writes an entry: "dyncal 0.1.0 (build ...)".
std::string programText();

/// What stands before the first entry.
extern const std::string kNoEntry;

/// SHA-256 of what an entry says: all but its place in the chain.
std::string contentSha256(const AuditEntry &entry);

/// SHA-256 of "PREVIOUS SEQUENCE CONTENT": with the content's hash alone the chain can be followed
/// through entries that are somebody else's.
std::string entrySha256(
    const std::string &previous, Index sequence, const std::string &contentSha256);

/// The entry as the next one behind `last` (null: the first): sequence, previous and hash filled
/// in.
AuditEntry chained(AuditEntry entry, const AuditEntry *last);

/// Sequence of the first entry that does not follow from the one before, or whose hash is not that
/// of what it says; empty for an unbroken chain from 1 on.
std::optional<Index> firstBreak(const std::vector<AuditEntry> &entries);

} // namespace dyncal
