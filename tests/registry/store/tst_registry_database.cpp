// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/registry_database.h"

#include "tests/support/made_registry.h"
#include "tests/support/postgres_server.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

Result<RegistryDatabase> opened(
    const std::string &address, RegistryAccess access = RegistryAccess::Write)
{
    return RegistryDatabase::open(*registryAddress(address), access);
}

std::string said(const Error &error)
{
    return english(error.message);
}

bool holds(const std::string &text, const std::string &part)
{
    return text.find(part) != text.npos;
}

/// What both kinds of database must do alike.
void expectValuesToComeBack(RegistryDatabase &database)
{
    QVERIFY(database.run("CREATE TABLE things (number BIGINT PRIMARY KEY, name TEXT NOT NULL)"));
    const QString odd = QString::fromUtf8("\u00e5 'quoted'; -- \"x\" \u4e2d\n%1");
    QVERIFY(database.run(
        "INSERT INTO things VALUES (?, ?)", {qint64(9007199254740993), QVariant(odd)}));
    QVERIFY(database.run("INSERT INTO things VALUES (?, ?)", {qint64(2), QString("")}));
    const auto rows = database.run("SELECT number, name FROM things ORDER BY number DESC");
    QVERIFY(rows);
    QCOMPARE(rows->size(), 2U);
    QCOMPARE((*rows)[0][0].toLongLong(), 9007199254740993);
    QCOMPARE((*rows)[0][1].toString(), odd);
    QVERIFY((*rows)[1][1].toString().isEmpty());
    QVERIFY(!database.run("INSERT INTO things VALUES (?, ?)", {qint64(2), QString("twice")}));
    QVERIFY(database.run("SELECT number FROM things WHERE number = 77")->empty());
    QVERIFY(!database.run("SELECT nothing FROM nowhere"));
    // After a failure inside a transaction the connection goes on.
    QVERIFY(!database.transaction([&]() -> Result<void> {
        const auto added = database.run("INSERT INTO things VALUES (3, 'undone')");
        return added ? database.run("SELECT nonsense").map([](const auto &) {})
                     : tl::unexpected<Error>(added.error());
    }));
    QCOMPARE(database.run("SELECT number FROM things")->size(), 2U);
}

} // namespace

/// Connections, whatever the database.
class TestRegistryDatabase : public QObject
{
    Q_OBJECT

private slots:
    void sqlite_keepsValues()
    {
        const ScratchFolder folder;
        auto database = opened(folder.file("r.sqlite"));
        QVERIFY(database);
        expectValuesToComeBack(*database);
    }

    void postgresql_keepsValues()
    {
        DYNCAL_NEEDS_POSTGRES();
        PostgresServer server;
        auto database = opened(server.database("values").toStdString());
        QVERIFY2(database, database ? "" : said(database.error()).c_str());
        expectValuesToComeBack(*database);
    }

    void newFile_getsItsFolder()
    {
        const ScratchFolder folder;
        QVERIFY(opened(folder.file("new/folders/r.sqlite")));
        QVERIFY(fs::exists(folder.file("new/folders/r.sqlite")));
    }

    void reading_makesNothing()
    {
        const ScratchFolder folder;
        const auto none = opened(folder.file("r.sqlite"), RegistryAccess::Read);
        QVERIFY(!none);
        QCOMPARE(none.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(!fs::exists(folder.file("r.sqlite")));
    }

    void reading_writesNothing()
    {
        const ScratchFolder folder;
        {
            auto database = opened(folder.file("r.sqlite"));
            QVERIFY(database->run("CREATE TABLE things (number BIGINT)"));
        }
        auto database = opened(folder.file("r.sqlite"), RegistryAccess::Read);
        QVERIFY(database);
        QVERIFY(database->run("SELECT number FROM things"));
        QVERIFY(!database->run("INSERT INTO things VALUES (1)"));
    }

    void placesThatCannotBe_areSaid()
    {
        const ScratchFolder folder;
        folder.write("file", "x", 1);
        for (const std::string &place : {folder.file("file/r.sqlite"), folder.file("")}) {
            const auto none = opened(place);
            QVERIFY(!none);
            QVERIFY2(holds(said(none.error()), place), said(none.error()).c_str());
        }
    }

    /// With the address, and never the password.
    void missingServer_isSaid()
    {
        const auto none = opened("postgresql://ann:secret@127.0.0.1:1/db");
        QVERIFY(!none);
        QCOMPARE(none.error().kind, ErrorKind::Usage);
        const std::string text = said(none.error());
        QVERIFY2(holds(text, "postgresql://127.0.0.1:1/db"), text.c_str());
        QVERIFY(!holds(text, "secret"));
    }
};

DYNCAL_TEST(TestRegistryDatabase)
#include "tst_registry_database.moc"
