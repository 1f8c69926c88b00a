// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "registry/store/registry_address.h"

#include <QVariant>

#include <functional>
#include <memory>
#include <vector>

namespace dyncal {

/// What a registry is opened for: to be looked at only, when nothing of it is made or changed; to
/// be changed, where it must be there; or to be written, when it is made where it is missing.
enum class RegistryAccess { Read, Change, Write };

/// A connection to the database of a registry: SQLite or PostgreSQL, the same statements for both.
/// All fail (Usage where the place is at fault, Internal otherwise) with the reason of the
/// database.
class RegistryDatabase
{
public:
    using Row = std::vector<QVariant>;

    /// Opens the database and waits at most a minute for other programs that write it. A file that
    /// is to be written is made if it is missing, and refused on a network folder. Needs no
    /// application object: where there is none it makes one for as long as it lives.
    static Result<RegistryDatabase> open(const RegistryAddress &address, RegistryAccess access);

    RegistryDatabase(RegistryDatabase &&) noexcept;
    RegistryDatabase &operator=(RegistryDatabase &&) noexcept;
    ~RegistryDatabase();

    const RegistryAddress &address() const;

    /// One statement with '?' for its values; the rows that it gives.
    Result<std::vector<Row>> run(
        const QString &statement, const std::vector<QVariant> &values = {});

    /// Runs `work` as one transaction that no other program writes in: all of it is on disk when
    /// this returns, or nothing where it fails. After a failure of the connection during the very
    /// end either may be true.
    Result<void> transaction(const std::function<Result<void>()> &work);

private:
    struct Private;
    explicit RegistryDatabase(std::unique_ptr<Private> opened);
    Result<void> begin();

    std::unique_ptr<Private> d;
};

} // namespace dyncal
