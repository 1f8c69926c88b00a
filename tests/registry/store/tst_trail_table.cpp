// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/trail_table.h"

#include "registry/store/registry_schema.h"
#include "tests/support/hostile_text.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

AuditEntry entryAbout(const std::string &object, const std::string &reason = {})
{
    return {.utc = kNoon,
        .who = "A. Berg",
        .action = "did",
        .object = object,
        .after = "{}",
        .reason = reason,
        .program = "dyncal 1"};
}

/// An empty registry's database.
struct Database
{
    ScratchFolder folder;
    RegistryDatabase database = std::move(
        *RegistryDatabase::open(*registryAddress(folder.file("r.sqlite")), RegistryAccess::Write));

    Database()
    {
        if (!bringUpToDate(database))
            std::abort();
    }
    Result<AuditEntry> add(const AuditEntry &entry)
    {
        Result<AuditEntry> added;
        const Result<void> done = database.transaction([&]() -> Result<void> {
            added = appendEntry(database, entry);
            return added.map([](const auto &) {});
        });
        return done ? added : tl::unexpected<Error>(done.error());
    }
};

} // namespace

/// The audit trail in the database.
class TestTrailTable : public QObject
{
    Q_OBJECT

private slots:
    void entries_areChainedAndComeBack()
    {
        Database place;
        std::vector<AuditEntry> added;
        for (const char *object : {"a", "b", "a", "c"})
            added.push_back(*place.add(entryAbout(object)));
        const auto read = allEntries(place.database);
        QVERIFY(*read == added);
        QVERIFY(!firstBreak(*read));
        QCOMPARE(read->front().sequence, 1);
        QCOMPARE(read->back().sequence, 4);
    }

    void oneObject_andAStretch()
    {
        Database place;
        for (const char *object : {"a", "b", "a", "c"})
            QVERIFY(place.add(entryAbout(object)));
        const auto ofA = entriesOf(place.database, "a");
        QCOMPARE(ofA->size(), 2U);
        QCOMPARE((*ofA)[1].sequence, 3);
        QVERIFY(entriesOf(place.database, "none")->empty());
        QVERIFY(entriesOf(place.database, "a' OR 'a' = 'a")->empty());
        const auto stretch = entriesBetween(place.database, 2, 3);
        QCOMPARE(stretch->size(), 2U);
        QCOMPARE(stretch->front().object, "b");
        QVERIFY(entriesBetween(place.database, 5, 9)->empty());
    }

    /// What a database cannot keep is made presentable first: the hash is of what is read back.
    void hostileTexts_keepTheChain()
    {
        Database place;
        std::size_t count = 0;
        for (const std::string &text : test::hostileTexts()) {
            AuditEntry entry = entryAbout(text, text);
            entry.who = entry.action = entry.before = entry.after = entry.program = text;
            QVERIFY(place.add(entry));
            ++count;
        }
        const auto read = allEntries(place.database);
        QCOMPARE(read->size(), count);
        QVERIFY(!firstBreak(*read));
    }

    void undoneEntry_leavesNoGap()
    {
        Database place;
        QVERIFY(place.add(entryAbout("a")));
        QVERIFY(!place.database.transaction([&]() -> Result<void> {
            const auto added = appendEntry(place.database, entryAbout("undone"));
            return added ? Result<void>(fail(ErrorKind::Usage, {"refused", {}}))
                         : tl::unexpected<Error>(added.error());
        }));
        QCOMPARE(place.add(entryAbout("b"))->sequence, 2);
        QVERIFY(!firstBreak(*allEntries(place.database)));
    }

    /// Two connections in turn: each goes on where the other ended.
    void twoConnections_makeOneChain()
    {
        Database place;
        RegistryDatabase other
            = std::move(*RegistryDatabase::open(place.database.address(), RegistryAccess::Write));
        for (int i = 0; i < 6; ++i) {
            RegistryDatabase &one = i % 2 == 0 ? place.database : other;
            QVERIFY(one.transaction(
                [&] { return appendEntry(one, entryAbout("x")).map([](const auto &) {}); }));
        }
        QCOMPARE(allEntries(other)->size(), 6U);
        QVERIFY(!firstBreak(*allEntries(place.database)));
    }
};

DYNCAL_TEST(TestTrailTable)
#include "tst_trail_table.moc"
