// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/certificates/certificate_record.h"
#include "registry/store/registry_database.h"
#include "registry/trail/audit_entry.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Rows of certificates by number, all or those of a condition. Fails (FileUnreadable) on a row
/// that is none, and as the database does.
Result<std::vector<CertificateRecord>> certificates(RegistryDatabase &database,
    const QString &where = {}, const std::vector<QVariant> &values = {});

/// Writes a row together with the entry of the audit trail that is about it, whose object and rows
/// are filled in; inside a transaction. `before` is empty for a new row.
Result<void> putCertificate(RegistryDatabase &database,
    const std::optional<CertificateRecord> &before, const CertificateRecord &after,
    AuditEntry entry);

/// Raises the counter; inside a transaction, which alone makes it so.
Result<Index> nextNumber(RegistryDatabase &database);

} // namespace dyncal
