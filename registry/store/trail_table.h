// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/store/registry_database.h"
#include "registry/trail/audit_entry.h"

namespace dyncal {

/// The audit trail in the database: only ever appended to.

/// Appends an entry, inside a transaction, and returns it with its place in the chain.
Result<AuditEntry> appendEntry(RegistryDatabase &database, const AuditEntry &entry);

/// Entries in their order: all, or those from `first` to `last`.
Result<std::vector<AuditEntry>> allEntries(RegistryDatabase &database);
Result<std::vector<AuditEntry>> entriesBetween(RegistryDatabase &database, Index first, Index last);

/// Entries about one object, in their order.
Result<std::vector<AuditEntry>> entriesOf(RegistryDatabase &database, const std::string &object);

} // namespace dyncal
