// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/certificate_table.h"

#include "registry/store/trail_table.h"

namespace dyncal {

Result<std::vector<CertificateRecord>> certificates(
    RegistryDatabase &database, const QString &where, const std::vector<QVariant> &values)
{
    const auto rows
        = database.run("SELECT record FROM certificates " + where + " ORDER BY number", values);
    if (!rows)
        return tl::unexpected<Error>(rows.error());
    std::vector<CertificateRecord> records;
    for (const auto &row : *rows) {
        const auto record = parseRecord(row.front().toString().toStdString());
        if (!record)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "The registry %1 holds a row that is no certificate; see dyncal verify, and take a copy from before."),
                    {database.address().shown()}});
        records.push_back(*record);
    }
    return records;
}

Result<void> putCertificate(RegistryDatabase &database,
    const std::optional<CertificateRecord> &before, const CertificateRecord &after,
    AuditEntry entry)
{
    entry.object = certificateObject(after.number);
    entry.before = before ? recordJson(*before) : "";
    entry.after = recordJson(after);
    const Result<AuditEntry> added = appendEntry(database, entry);
    if (!added)
        return tl::unexpected<Error>(added.error());
    const auto text = [](const std::string &value) { return QString::fromStdString(value); };
    return database
        .run("INSERT INTO certificates (number, state, job, job_sha256, record, entry) "
             "VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (number) DO UPDATE SET state = excluded.state, "
             "job = excluded.job, job_sha256 = excluded.job_sha256, record = excluded.record, "
             "entry = excluded.entry",
            {static_cast<qint64>(after.number), text(certificateStateName(after.state)),
                text(after.job), text(after.jobSha256), text(added->after),
                static_cast<qint64>(added->sequence)})
        .map([](const auto &) {});
}

Result<Index> nextNumber(RegistryDatabase &database)
{
    const auto raised
        = database.run("UPDATE counters SET last = last + 1 WHERE name = 'certificates'");
    const auto counter
        = raised ? database.run("SELECT last FROM counters WHERE name = 'certificates'") : raised;
    if (!counter)
        return tl::unexpected<Error>(counter.error());
    if (counter->empty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "The registry %1 has lost its counter; take a copy from before."),
                {database.address().shown()}});
    return static_cast<Index>(counter->front().front().toLongLong());
}

} // namespace dyncal
