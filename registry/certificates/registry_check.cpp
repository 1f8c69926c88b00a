// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/registry_check.h"

#include "registry/store/registry_schema.h"
#include "registry/store/trail_table.h"

#include <algorithm>
#include <map>
#include <set>

namespace dyncal {
namespace {

using Row = RegistryDatabase::Row;
using Difference = std::optional<Message>;
using LastEntries = std::map<std::string, const AuditEntry *>; ///< that changed a row, by object

std::string textAt(const Row &row, std::size_t column)
{
    return row[column].toString().toStdString();
}

/// SQLite: the file's own structure, and that its tables are those that the program makes.
Result<Difference> checkDatabase(RegistryDatabase &database)
{
    if (database.address().isServer())
        return Difference();
    const auto found = database.run("PRAGMA integrity_check");
    if (!found)
        return tl::unexpected<Error>(found.error());
    if (found->empty() || textAt(found->front(), 0) != "ok")
        return Difference({DYNCAL_TEXT("core", "The database is damaged (%1)."),
            {found->empty() ? "" : textAt(found->front(), 0)}});
    const auto tables
        = database.run("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY rowid");
    if (!tables)
        return tl::unexpected<Error>(tables.error());
    std::set<std::string> made;
    for (const SchemaStep &step : schemaSteps())
        for (const std::string statement : step)
            if (statement.starts_with("CREATE"))
                made.insert(statement);
    for (const Row &row : *tables)
        if (made.erase(textAt(row, 0)) == 0)
            return Difference({DYNCAL_TEXT("core", "A table is not as the program makes it (%1)."),
                {textAt(row, 0)}});
    return made.empty()
        ? Difference()
        : Difference({DYNCAL_TEXT("core", "A table is missing (%1)."), {*made.begin()}});
}

/// SQLite keeps bytes in a column of texts too, and they read the same: every value must be of the
/// kind of its column.
Result<Difference> checkKinds(RegistryDatabase &database)
{
    if (database.address().isServer())
        return Difference();
    for (const QString table : {"registry_schema", "counters", "trail", "certificates", "cards"}) {
        const auto columns
            = database.run("SELECT name, type FROM pragma_table_info('" + table + "')");
        if (!columns)
            return tl::unexpected<Error>(columns.error());
        QStringList wrong;
        for (const Row &column : *columns)
            wrong << QString("typeof(%1) <> '%2'")
                         .arg(column[0].toString(),
                             column[1].toString() == "BIGINT" ? "integer" : "text");
        const auto found
            = database.run("SELECT count(*) FROM " + table + " WHERE " + wrong.join(" OR "));
        if (!found)
            return tl::unexpected<Error>(found.error());
        if (found->front().front().toLongLong() > 0)
            return Difference({DYNCAL_TEXT("core", "The table %1 holds values of another kind."),
                {table.toStdString()}});
    }
    return Difference();
}

Result<Difference> checkVersion(RegistryDatabase &database)
{
    const auto rows = database.run("SELECT version FROM registry_schema");
    if (!rows)
        return tl::unexpected<Error>(rows.error());
    const auto known = static_cast<qlonglong>(schemaSteps().size());
    return rows->size() == 1 && rows->front().front().toLongLong() == known
        ? Difference()
        : Difference(
            {DYNCAL_TEXT("core", "The version of the tables is not %1."), {std::to_string(known)}});
}

Difference checkChain(const std::vector<AuditEntry> &entries)
{
    const std::optional<Index> broken = firstBreak(entries);
    if (!broken)
        return {};
    return Message{
        DYNCAL_TEXT("core",
            "The audit trail is broken at entry %1: it was changed, or an entry before it is missing."),
        {std::to_string(*broken)}};
}

/// Every change of a row begins where the last one ended.
Difference checkChanges(const std::vector<AuditEntry> &entries, LastEntries &last)
{
    for (const AuditEntry &entry : entries) {
        if (entry.after.empty())
            continue;
        const AuditEntry *&before = last[entry.object];
        if (entry.before != (before ? before->after : std::string()))
            return Message{
                DYNCAL_TEXT("core",
                    "Entry %1 of the audit trail does not begin where the entry before about %2 ended."),
                {std::to_string(entry.sequence), entry.object}};
        before = &entry;
    }
    return {};
}

Message notAsWritten(const std::string &object)
{
    return {DYNCAL_TEXT("core", "The row of %1 is not what the audit trail says of it."), {object}};
}

/// A row: its object, then what must be as in the entry.
bool isAsWritten(
    LastEntries &last, const std::string &object, const std::string &record, Index entry)
{
    const auto found = last.find(object);
    if (found == last.end() || found->second->after != record || found->second->sequence != entry)
        return false;
    last.erase(found);
    return true;
}

Result<Difference> checkCertificates(RegistryDatabase &database, LastEntries &last)
{
    const auto rows = database.run(
        "SELECT number, state, job, job_sha256, record, entry FROM certificates ORDER BY number");
    const auto counters = rows ? database.run("SELECT name, last FROM counters") : rows;
    if (!counters)
        return tl::unexpected<Error>(counters.error());
    Index number = 0;
    for (const Row &row : *rows) {
        const std::string object = certificateObject(++number);
        const auto record = parseRecord(textAt(row, 4));
        if (!record || !isAsWritten(last, object, textAt(row, 4), row[5].toLongLong())
            || row[0].toLongLong() != number || record->number != number
            || textAt(row, 1) != certificateStateName(record->state)
            || textAt(row, 2) != record->job || textAt(row, 3) != record->jobSha256)
            return Difference(notAsWritten(object));
    }
    if (counters->size() != 1 || textAt(counters->front(), 0) != "certificates"
        || counters->front()[1].toLongLong() != number)
        return Difference(
            {DYNCAL_TEXT("core",
                 "The counter of the certificates is not at %1, the last number that was given."),
                {std::to_string(number)}});
    return Difference();
}

Result<Difference> checkCards(RegistryDatabase &database, LastEntries &last)
{
    const auto rows
        = database.run("SELECT kind, name, record, entry FROM cards ORDER BY kind, name");
    if (!rows)
        return tl::unexpected<Error>(rows.error());
    for (const Row &row : *rows) {
        const std::string object = textAt(row, 0) + ' ' + textAt(row, 1);
        if (!isAsWritten(last, object, textAt(row, 2), row[3].toLongLong()))
            return Difference(notAsWritten(object));
    }
    return last.empty()
        ? Difference()
        : Difference({DYNCAL_TEXT("core", "The row of %1 is missing."), {last.begin()->first}});
}

Index anchoredEntries(
    const std::vector<AuditEntry> &entries, const std::vector<CertificateRecord> &records)
{
    std::set<std::string> heads;
    for (const CertificateRecord &record : records)
        heads.insert(record.head);
    const auto last = std::find_if(entries.rbegin(), entries.rend(),
        [&](const AuditEntry &entry) { return heads.contains(entry.sha256); });
    return last == entries.rend() ? 0 : last->sequence;
}

Result<Difference> firstDifference(
    RegistryDatabase &database, const std::vector<AuditEntry> &entries)
{
    LastEntries last;
    if (Difference difference = checkChain(entries))
        return difference;
    if (Difference difference = checkChanges(entries, last))
        return difference;
    Result<Difference> found = checkCertificates(database, last);
    return found && !*found ? checkCards(database, last) : found;
}

} // namespace

Result<RegistryCheck> checkRegistry(CertificateRegister &registry)
{
    RegistryDatabase &database = registry.database();
    RegistryCheck check;
    Result<Difference> found = checkDatabase(database);
    if (found && !*found)
        found = checkVersion(database);
    if (found && !*found)
        found = checkKinds(database);
    if (!found)
        return tl::unexpected<Error>(found.error());
    check.firstDifference = *found;
    if (*found)
        return check;
    const auto entries = allEntries(database);
    if (!entries)
        return tl::unexpected<Error>(entries.error());
    check.entries = std::ssize(*entries);
    check.head = entries->empty() ? "" : entries->back().sha256;
    found = firstDifference(database, *entries);
    if (!found)
        return tl::unexpected<Error>(found.error());
    check.firstDifference = *found;
    if (*found)
        return check;
    const auto records = registry.all();
    if (!records)
        return tl::unexpected<Error>(records.error());
    check.anchored = anchoredEntries(*entries, *records);
    return check;
}

} // namespace dyncal
