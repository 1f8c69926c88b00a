// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/registry_schema.h"

#include <algorithm>
#include <filesystem>
#include <string>

namespace dyncal {
namespace {

constexpr const char *kTables[]{"registry_schema", "counters", "trail", "certificates", "cards"};

Result<qint64> countOf(
    RegistryDatabase &database, const QString &statement, const std::vector<QVariant> &values = {})
{
    return database.run(statement, values).map([](const auto &rows) {
        return rows.empty() ? qint64(0) : rows.front().front().toLongLong();
    });
}

/// Tables of the database: all, or the one that only a registry has.
Result<qint64> tableCount(RegistryDatabase &database, bool onlyOurs)
{
    const bool isServer = database.address().isServer();
    QString statement = isServer
        ? "SELECT count(*) FROM information_schema.tables WHERE table_schema = current_schema()"
        : "SELECT count(*) FROM sqlite_master WHERE type = 'table'";
    if (onlyOurs)
        statement += QString(" AND %1 = 'registry_schema'").arg(isServer ? "table_name" : "name");
    return countOf(database, statement);
}

tl::unexpected<Error> isNewer(const RegistryDatabase &database, int version, std::size_t known)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The registry %1 has version %2 and this program knows versions up to %3; open it with the program that wrote it, or a newer one."),
            {database.address().shown(), std::to_string(version), std::to_string(known)}});
}

Result<void> backUpFile(RegistryDatabase &database, int version)
{
    if (database.address().isServer() || version == 0)
        return {};
    const std::string file = database.address().file + ".before-" + std::to_string(version + 1);
    std::error_code ignored;
    std::filesystem::remove(file, ignored); // of a change that did not come to its end
    return database.run("VACUUM INTO ?", {QString::fromStdString(file)}).map([](const auto &) {});
}

Result<void> runAll(RegistryDatabase &database, const std::vector<QString> &statements)
{
    for (const QString &statement : statements)
        if (const auto done = database.run(statement); !done)
            return tl::unexpected<Error>(done.error());
    return {};
}

Result<void> backUpTables(RegistryDatabase &database, int version)
{
    std::vector<QString> statements;
    if (database.address().isServer() && version > 0)
        for (const char *table : kTables)
            statements.push_back(QString("CREATE TABLE %1_before_%2 AS SELECT * FROM %1")
                                     .arg(table)
                                     .arg(version + 1));
    return runAll(database, statements);
}

Result<void> takeSteps(
    RegistryDatabase &database, const std::vector<SchemaStep> &steps, std::size_t from)
{
    for (std::size_t i = from; i < steps.size(); ++i) {
        const Result<void> done
            = runAll(database, std::vector<QString>(steps[i].begin(), steps[i].end()));
        if (!done)
            return done;
    }
    return database
        .run("UPDATE registry_schema SET version = ?",
            {QVariant::fromValue(static_cast<qint64>(steps.size()))})
        .map([](const auto &) {});
}

} // namespace

const std::vector<SchemaStep> &schemaSteps()
{
    static const std::vector<SchemaStep> steps{{"CREATE TABLE registry_schema (version BIGINT NOT NULL)",
        "INSERT INTO registry_schema (version) VALUES (1)",
        "CREATE TABLE counters (name VARCHAR(64) PRIMARY KEY, last BIGINT NOT NULL)",
        "INSERT INTO counters (name, last) VALUES ('certificates', 0)",
        "CREATE TABLE trail (sequence BIGINT PRIMARY KEY, utc TEXT NOT NULL, who TEXT NOT NULL, action TEXT NOT NULL, object TEXT NOT NULL, row_before TEXT NOT NULL, row_after TEXT NOT NULL, reason TEXT NOT NULL, program TEXT NOT NULL, previous TEXT NOT NULL, sha256 TEXT NOT NULL)",
        "CREATE TABLE certificates (number BIGINT PRIMARY KEY, state TEXT NOT NULL, job TEXT NOT NULL, job_sha256 TEXT NOT NULL, record TEXT NOT NULL, entry BIGINT NOT NULL)",
        "CREATE TABLE cards (kind VARCHAR(64) NOT NULL, name VARCHAR(400) NOT NULL, record TEXT NOT NULL, entry BIGINT NOT NULL, PRIMARY KEY (kind, name))"}};
    return steps;
}

Result<int> schemaVersion(RegistryDatabase &database)
{
    const Result<qint64> all = tableCount(database, false);
    const Result<qint64> ours = all ? tableCount(database, true) : all;
    if (!ours)
        return tl::unexpected<Error>(ours.error());
    if (*ours == 0 && *all > 0)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The database %1 holds other tables than those of a registry; name another file or database."),
                {database.address().shown()}});
    if (*ours == 0)
        return 0;
    return countOf(database, "SELECT version FROM registry_schema").map([](qint64 version) {
        return static_cast<int>(version);
    });
}

Result<void> bringUpToDate(RegistryDatabase &database, const std::vector<SchemaStep> &steps)
{
    const Result<int> before = schemaVersion(database);
    if (!before)
        return tl::unexpected<Error>(before.error());
    const auto known = static_cast<int>(steps.size());
    if (*before > known)
        return isNewer(database, *before, steps.size());
    if (*before == known)
        return {};
    if (const Result<void> kept = backUpFile(database, *before); !kept)
        return kept;
    return database.transaction([&]() -> Result<void> {
        const Result<int> now = schemaVersion(database); // another program may have been quicker
        if (!now)
            return tl::unexpected<Error>(now.error());
        if (*now >= known)
            return {};
        return backUpTables(database, *now).and_then([&] {
            return takeSteps(database, steps, static_cast<std::size_t>(*now));
        });
    });
}

Result<void> checkSchema(RegistryDatabase &database)
{
    const Result<int> version = schemaVersion(database);
    if (!version)
        return tl::unexpected<Error>(version.error());
    const std::size_t known = schemaSteps().size();
    if (*version > static_cast<int>(known))
        return isNewer(database, *version, known);
    if (*version < static_cast<int>(known))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The registry %1 has version %2 and version %3 is needed to read it; the next dyncal issue or dyncal registry that writes it changes it, after a backup."),
                {database.address().shown(), std::to_string(*version), std::to_string(known)}});
    return {};
}

} // namespace dyncal
