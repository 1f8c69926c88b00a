// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/registry_schema.h"

#include "registry/certificates/registry_check.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

RegistryDatabase openedDatabase(const std::string &file)
{
    return std::move(*RegistryDatabase::open(*registryAddress(file), RegistryAccess::Write));
}

/// The steps of a program to come: one more table, filled from what is there.
std::vector<SchemaStep> laterSteps()
{
    std::vector<SchemaStep> steps = schemaSteps();
    steps.push_back({"CREATE TABLE later (number BIGINT PRIMARY KEY)",
        "INSERT INTO later SELECT number FROM certificates"});
    return steps;
}

qint64 numberOf(RegistryDatabase &database, const QString &statement)
{
    const auto rows = database.run(statement);
    return rows ? rows->front().front().toLongLong() : -1;
}

} // namespace

/// Versions of the tables.
class TestRegistrySchema : public QObject
{
    Q_OBJECT

private slots:
    void newFile_getsTheTables()
    {
        const ScratchFolder folder;
        RegistryDatabase database = openedDatabase(folder.file("r.sqlite"));
        QCOMPARE(*schemaVersion(database), 0);
        QVERIFY(!checkSchema(database));
        QVERIFY(bringUpToDate(database));
        QCOMPARE(*schemaVersion(database), static_cast<int>(schemaSteps().size()));
        QVERIFY(checkSchema(database));
        QVERIFY(bringUpToDate(database)); // nothing to do
        QVERIFY(!std::filesystem::exists(folder.file("r.sqlite.before-1")));
    }

    void olderTables_areChangedAfterABackup()
    {
        const ScratchFolder folder;
        {
            CertificateRegister registry = openedRegister(folder.file("r.sqlite"));
            QCOMPARE(issueAs(registry, numberRequest("a")), 1);
            QCOMPARE(issueAs(registry, numberRequest("b")), 2);
        }
        RegistryDatabase database = openedDatabase(folder.file("r.sqlite"));
        QVERIFY(bringUpToDate(database, laterSteps()));
        QCOMPARE(*schemaVersion(database), 2);
        QCOMPARE(numberOf(database, "SELECT count(*) FROM later"), 2);
        // The backup is the registry as it was.
        CertificateRegister before = openedRegister(folder.file("r.sqlite.before-2"));
        QVERIFY(!checkRegistry(before)->firstDifference);
        QCOMPARE(before.all()->size(), 2U);
    }

    /// A change that fails leaves the tables as they were.
    void failingChange_changesNothing()
    {
        const ScratchFolder folder;
        {
            CertificateRegister registry = openedRegister(folder.file("r.sqlite"));
        }
        RegistryDatabase database = openedDatabase(folder.file("r.sqlite"));
        std::vector<SchemaStep> steps = laterSteps();
        steps.back().push_back("INSERT INTO nowhere VALUES (1)");
        QVERIFY(!bringUpToDate(database, steps));
        QCOMPARE(*schemaVersion(database), 1);
        QCOMPARE(numberOf(database, "SELECT count(*) FROM sqlite_master WHERE name = 'later'"), 0);
        QVERIFY(
            bringUpToDate(database, laterSteps())); // the backup of the failed one is no obstacle
    }

    void newerTables_areRefusedWithBothVersions()
    {
        const ScratchFolder folder;
        {
            RegistryDatabase database = openedDatabase(folder.file("r.sqlite"));
            QVERIFY(bringUpToDate(database, laterSteps()));
        }
        for (const auto &opened : {CertificateRegister::open(folder.file("r.sqlite")),
                 CertificateRegister::openToRead(folder.file("r.sqlite"))}) {
            QVERIFY(!opened);
            const std::string said = english(opened.error().message);
            QVERIFY2(said.find("has version 2 and this program knows versions up to 1")
                    != std::string::npos,
                said.c_str());
        }
    }

    void databaseOfSomethingElse_isLeftAlone()
    {
        const ScratchFolder folder;
        {
            RegistryDatabase database = openedDatabase(folder.file("r.sqlite"));
            QVERIFY(database.run("CREATE TABLE songs (title TEXT)"));
        }
        const std::string before = contentOf(folder.file("r.sqlite"));
        QVERIFY(!CertificateRegister::open(folder.file("r.sqlite")));
        QCOMPARE(contentOf(folder.file("r.sqlite")), before);
    }

    void fileThatIsNoDatabase_isLeftAlone()
    {
        const ScratchFolder folder;
        const std::string text(5000, 'x');
        folder.write("r.sqlite", text.data(), text.size());
        const auto opened = CertificateRegister::open(folder.file("r.sqlite"));
        QVERIFY(!opened);
        QCOMPARE(contentOf(folder.file("r.sqlite")), text);
    }

    /// A transaction that fails is undone whole, and the connection can be used on.
    void failedTransaction_isUndone()
    {
        const ScratchFolder folder;
        RegistryDatabase database = openedDatabase(folder.file("r.sqlite"));
        QVERIFY(bringUpToDate(database));
        const Result<void> done = database.transaction([&]() -> Result<void> {
            if (!database.run("UPDATE counters SET last = 17"))
                return {};
            return fail(ErrorKind::Usage, {"refused", {}});
        });
        QVERIFY(!done);
        QCOMPARE(english(done.error().message), "refused");
        QCOMPARE(numberOf(database, "SELECT last FROM counters"), 0);
        QVERIFY(database.transaction([&] {
            return database.run("UPDATE counters SET last = 18").map([](const auto &) {});
        }));
        QCOMPARE(numberOf(database, "SELECT last FROM counters"), 18);
    }

    /// Two connections: the second waits for the first, and sees what it has written.
    void writers_waitForEachOther()
    {
        const ScratchFolder folder;
        RegistryDatabase one = openedDatabase(folder.file("r.sqlite"));
        QVERIFY(bringUpToDate(one));
        std::atomic<bool> isDone = false;
        QThread *other = QThread::create([&] {
            RegistryDatabase second = openedDatabase(folder.file("r.sqlite"));
            const Result<void> added = second.transaction([&] {
                return second.run("UPDATE counters SET last = last + 1").map([](const auto &) {});
            });
            isDone = added.has_value();
        });
        QVERIFY(one.transaction([&]() -> Result<void> {
            const auto first = one.run("UPDATE counters SET last = 40");
            other->start();
            QThread::msleep(200);
            return first.map([](const auto &) {});
        }));
        other->wait();
        delete other;
        QVERIFY(isDone);
        QCOMPARE(numberOf(one, "SELECT last FROM counters"), 41);
    }
};

DYNCAL_TEST(TestRegistrySchema)
#include "tst_registry_schema.moc"
