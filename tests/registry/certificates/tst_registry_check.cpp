// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/registry_check.h"

#include "registry/store/trail_table.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QProcess>
#include <QtTest>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// A registry in which everything has happened, and copies of it to be damaged.
class Original
{
public:
    Original()
    {
        CertificateRegister registry = openedRegister(path());
        for (const char *job : {"a", "b", "c", "d"})
            issueAs(registry, numberRequest(job));
        NumberRequest amendment = numberRequest("a", "corrected");
        amendment.amends = 1;
        issueAs(registry, amendment);
        registry.withdraw(2, "A. Berg", "damaged reference", kNoon);
        registry.reserve(numberRequest("e"));
        registry.markVoid(6, "A. Berg", "sensor broke", kNoon);
        registry.reserve(numberRequest("f"));
    }
    std::string path() const { return m_folder.file("registry.sqlite"); }
    std::string file(const std::string &name) const { return m_folder.file(name); }

    /// What verify says of a copy that a statement was run in.
    std::string faultAfter(const QString &statement) const
    {
        CertificateRegister copy = openedRegister(copied());
        if (!copy.database().run(statement))
            return "the statement failed";
        return faultOf(copy);
    }

    static std::string faultOf(CertificateRegister &registry)
    {
        const auto check = checkRegistry(registry);
        if (!check)
            return "unreadable";
        return check->firstDifference ? english(*check->firstDifference) : std::string();
    }

    std::string copied() const
    {
        std::filesystem::copy_file(
            path(), file("copy.sqlite"), std::filesystem::copy_options::overwrite_existing);
        return file("copy.sqlite");
    }

private:
    ScratchFolder m_folder;
};

/// What sqlite3 prints of the database: its logical content.
QByteArray dumpOf(const std::string &path)
{
    QProcess process;
    process.start("sqlite3", {QString::fromStdString(path), ".dump"});
    process.waitForFinished();
    return process.readAllStandardOutput() + process.readAllStandardError();
}

} // namespace

/// The registry held against itself.
class TestRegistryCheck : public QObject
{
    Q_OBJECT

    Original m_original;

private slots:
    void wholeRegistry_hasNoDifference()
    {
        CertificateRegister registry = openedRegister(m_original.path());
        const auto check = checkRegistry(registry);
        QVERIFY(check && !check->firstDifference);
        QCOMPARE(check->entries, 15);
        QCOMPARE(check->head, allEntries(registry.database())->back().sha256);
        // The last certificate that was issued is number 5, with the head of its reservation.
        QCOMPARE(check->anchored, 9);
    }

    void emptyRegistry_isWhole()
    {
        const ScratchFolder folder;
        CertificateRegister registry = openedRegister(folder.file("r.sqlite"));
        QCOMPARE(Original::faultOf(registry), std::string());
        QCOMPARE(checkRegistry(registry)->anchored, 0);
    }

    void everyTampering_isNamed_data()
    {
        QTest::addColumn<QString>("statement");
        QTest::addColumn<QString>("said");
        const auto row = [](const char *name, const char *statement, const char *said) {
            QTest::newRow(name) << QString(statement) << QString(said);
        };
        row("state", "UPDATE certificates SET state = 'issued' WHERE number = 2",
            "The row of certificate 2");
        row("record",
            "UPDATE certificates SET record = replace(record, 'Acme', 'Bcme') WHERE number = 3",
            "The row of certificate 3");
        row("hash", "UPDATE certificates SET job_sha256 = 'x' WHERE number = 4",
            "The row of certificate 4");
        row("entry", "UPDATE certificates SET entry = entry + 1 WHERE number = 1",
            "The row of certificate 1");
        row("row gone", "DELETE FROM certificates WHERE number = 4", "The row of certificate 4");
        row("last row gone", "DELETE FROM certificates WHERE number = 7", "The counter");
        row("row added",
            "INSERT INTO certificates SELECT 8, state, job, job_sha256, record, entry FROM certificates WHERE number = 7",
            "The row of certificate 8");
        row("counter", "UPDATE counters SET last = 3", "The counter");
        row("counter gone", "DELETE FROM counters", "The counter");
        row("who", "UPDATE trail SET who = 'nobody' WHERE sequence = 5",
            "The audit trail is broken at entry 5");
        row("reason", "UPDATE trail SET reason = 'other' WHERE action = 'withdrawn'",
            "The audit trail is broken");
        row("entry gone", "DELETE FROM trail WHERE sequence = 2",
            "The audit trail is broken at entry 3");
        row("first entry gone", "DELETE FROM trail WHERE sequence = 1",
            "The audit trail is broken at entry 2");
        row("last entry gone", "DELETE FROM trail WHERE sequence = 15", "The row of certificate 7");
        row("card", "INSERT INTO cards VALUES ('sensor', 'x', '{}', 1)", "The row of sensor x");
        row("table", "CREATE TABLE more (x TEXT)", "A table is not as the program makes it");
        row("index", "CREATE INDEX more ON trail (who)", "A table is not as the program makes it");
        row("kind", "UPDATE trail SET who = CAST(who AS BLOB) WHERE sequence = 3",
            "The table trail holds values of another kind");
        row("version", "UPDATE registry_schema SET version = 9", "The version of the tables");
    }

    void everyTampering_isNamed()
    {
        QFETCH(QString, statement);
        QFETCH(QString, said);
        const std::string fault = m_original.faultAfter(statement);
        QVERIFY2(fault.starts_with(said.toStdString()), fault.c_str());
    }

    /// One who writes an entry and the hashes behind it anew is betrayed by the row, or by what
    /// stands on the certificates: here by neither, because all are rewritten (docs/registry.md).
    void rewrittenEntry_contradictsItsRow()
    {
        CertificateRegister copy = openedRegister(m_original.copied());
        auto entries = *allEntries(copy.database());
        const AuditEntry *last = nullptr;
        for (AuditEntry &entry : entries) {
            if (entry.sequence == 7)
                entry.after.replace(entry.after.find("Acme"), 4, "Bcme");
            entry = chained(entry, last);
            last = &entry;
            QVERIFY(copy.database().run(
                "UPDATE trail SET row_after = ?, previous = ?, sha256 = ? WHERE sequence = ?",
                {QString::fromStdString(entry.after), QString::fromStdString(entry.previous),
                    QString::fromStdString(entry.sha256), static_cast<qint64>(entry.sequence)}));
        }
        QVERIFY(!Original::faultOf(copy).empty());
    }

    /// Each flipped bit of the file is reported, or the content is what it was.
    void flippedBits_areReportedOrChangeNothing()
    {
        const std::string whole = contentOf(m_original.path());
        const QByteArray dump = dumpOf(m_original.path());
        QVERIFY(dump.contains("CREATE TABLE trail"));
        std::mt19937_64 random(20261126);
        int harmless = 0;
        const int count = trials::count(150, 3000);
        for (int i = 0; i < count; ++i) {
            std::string bytes = whole;
            const std::size_t at = random() % bytes.size();
            const auto bit = static_cast<int>(random() % 8);
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
            std::ofstream(m_original.file("flipped.sqlite"), std::ios::binary) << bytes;
            Result<CertificateRegister> opened
                = CertificateRegister::openToRead(m_original.file("flipped.sqlite"));
            const std::string fault = opened ? Original::faultOf(*opened) : "unreadable";
            if (!fault.empty())
                continue;
            ++harmless;
            QVERIFY2(dumpOf(m_original.file("flipped.sqlite")) == dump,
                qPrintable(QString("byte %1, bit %2").arg(at).arg(bit)));
        }
        qInfo("%d flips, %d of them without a change of the content", count, harmless);
    }
};

DYNCAL_TEST(TestRegistryCheck)
#include "tst_registry_check.moc"
