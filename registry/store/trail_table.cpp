// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/trail_table.h"

#include "core/base/foreign_text.h"

namespace dyncal {
namespace {

using Row = RegistryDatabase::Row;

constexpr const char *kColumns
    = "sequence, utc, who, action, object, row_before, row_after, reason, program, previous, sha256";
constexpr std::string AuditEntry::*kTexts[]{&AuditEntry::utc, &AuditEntry::who, &AuditEntry::action,
    &AuditEntry::object, &AuditEntry::before, &AuditEntry::after, &AuditEntry::reason,
    &AuditEntry::program, &AuditEntry::previous, &AuditEntry::sha256};

AuditEntry entryOf(const Row &row)
{
    AuditEntry entry;
    entry.sequence = row.front().toLongLong();
    for (std::size_t i = 0; i < std::size(kTexts); ++i)
        entry.*kTexts[i] = row[i + 1].toString().toStdString();
    return entry;
}

Result<std::vector<AuditEntry>> selected(
    RegistryDatabase &database, const QString &where, const std::vector<QVariant> &values)
{
    return database.run(QString("SELECT %1 FROM trail %2").arg(kColumns, where), values)
        .map([](const std::vector<Row> &rows) {
            std::vector<AuditEntry> entries;
            for (const Row &row : rows)
                entries.push_back(entryOf(row));
            return entries;
        });
}

} // namespace

Result<AuditEntry> appendEntry(RegistryDatabase &database, const AuditEntry &entry)
{
    const auto last = selected(database, "ORDER BY sequence DESC LIMIT 1", {});
    if (!last)
        return tl::unexpected<Error>(last.error());
    // As a database keeps it, or the hash would be of other bytes than those that are read back.
    AuditEntry kept = entry;
    for (const auto text : kTexts)
        kept.*text = presentable(kept.*text, LineBreaks::Keep);
    const AuditEntry added = chained(kept, last->empty() ? nullptr : &last->front());
    std::vector<QVariant> values{static_cast<qint64>(added.sequence)};
    for (const auto text : kTexts)
        values.push_back(QString::fromStdString(added.*text));
    return database
        .run(QString("INSERT INTO trail (%1) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
                 .arg(kColumns),
            values)
        .map([&](const auto &) { return added; });
}

Result<std::vector<AuditEntry>> allEntries(RegistryDatabase &database)
{
    return selected(database, "ORDER BY sequence", {});
}

Result<std::vector<AuditEntry>> entriesBetween(RegistryDatabase &database, Index first, Index last)
{
    return selected(database, "WHERE sequence BETWEEN ? AND ? ORDER BY sequence",
        {static_cast<qint64>(first), static_cast<qint64>(last)});
}

Result<std::vector<AuditEntry>> entriesOf(RegistryDatabase &database, const std::string &object)
{
    return selected(
        database, "WHERE object = ? ORDER BY sequence", {QString::fromStdString(object)});
}

} // namespace dyncal
