// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/store/registry_database.h"

namespace dyncal {

/// What leads from one version of the tables to the next.
using SchemaStep = std::vector<const char *>;

/// The steps of this program; the version is their number.
const std::vector<SchemaStep> &schemaSteps();

/// The version of the tables that are there; 0: an empty database. Fails (Usage) if it holds
/// something else than a registry.
Result<int> schemaVersion(RegistryDatabase &database);

/// Makes the tables, or changes those of an older program, as one transaction. Before a change a
/// backup is made: of SQLite the file "REGISTRY.before-VERSION" beside it, on a server the tables
/// under the names "TABLE_before_VERSION". Fails (Usage) on tables of a newer program.
Result<void> bringUpToDate(
    RegistryDatabase &database, const std::vector<SchemaStep> &steps = schemaSteps());

/// Fails (Usage) on tables that are not of the version of this program: before reading.
Result<void> checkSchema(RegistryDatabase &database);

} // namespace dyncal
