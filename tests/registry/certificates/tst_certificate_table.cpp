// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/certificate_table.h"

#include "registry/store/trail_table.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// The tables of a registry, without the rules of the register.
struct Tables
{
    ScratchFolder folder;
    CertificateRegister registry = openedRegister(folder.file("registry.sqlite"));
    RegistryDatabase &database = registry.database();

    Result<void> put(const std::optional<CertificateRecord> &before, const CertificateRecord &after)
    {
        const AuditEntry entry = {.utc = kNoon, .who = "A", .action = "did"};
        return database.transaction([&] { return putCertificate(database, before, after, entry); });
    }
};

CertificateRecord recordOf(Index number, const std::string &job)
{
    return {.number = number, .job = job, .jobSha256 = job + "hash"};
}

} // namespace

/// Rows of certificates.
class TestCertificateTable : public QObject
{
    Q_OBJECT

private slots:
    void rows_comeBackByNumberAndCondition()
    {
        Tables tables;
        for (const Index number : {3, 1, 2})
            QVERIFY(tables.put({}, recordOf(number, number == 2 ? "b" : "a")));
        const auto all = certificates(tables.database);
        QCOMPARE(all->size(), 3U);
        QCOMPARE((*all)[0].number, 1);
        QCOMPARE((*all)[2].number, 3);
        const auto ofA = certificates(tables.database, "WHERE job = ?", {QString("a")});
        QCOMPARE(ofA->size(), 2U);
        QVERIFY(certificates(tables.database, "WHERE number = ?", {qint64(9)})->empty());
        QVERIFY(!certificates(tables.database, "WHERE nonsense"));
    }

    void change_holdsTheRowBeforeAndAfter()
    {
        Tables tables;
        const CertificateRecord before = recordOf(1, "a");
        CertificateRecord after = before;
        after.state = CertificateState::Void;
        QVERIFY(tables.put({}, before) && tables.put(before, after));
        const auto entries = entriesOf(tables.database, "certificate 1");
        QCOMPARE(entries->size(), 2U);
        QCOMPARE((*entries)[0].before, "");
        QCOMPARE((*entries)[1].before, (*entries)[0].after);
        QCOMPARE((*entries)[1].after, recordJson(after));
        QVERIFY((certificates(tables.database) == std::vector<CertificateRecord>{after}));
    }

    void rowThatIsNone_isSaid()
    {
        Tables tables;
        QVERIFY(tables.put({}, recordOf(1, "a")));
        QVERIFY(tables.database.run("UPDATE certificates SET record = '{}'"));
        const auto read = certificates(tables.database);
        QVERIFY(!read);
        QCOMPARE(read.error().kind, ErrorKind::FileUnreadable);
    }

    /// A number that is not used is not lost: the counter goes back with its transaction.
    void numbers_comeBackWithTheTransaction()
    {
        Tables tables;
        Index number = 0;
        const auto next = [&](bool isUsed) {
            return tables.database
                .transaction([&]() -> Result<void> {
                    const Result<Index> given = nextNumber(tables.database);
                    number = given.value_or(0);
                    return isUsed ? Result<void>() : fail(ErrorKind::Usage, {"not used", {}});
                })
                .has_value();
        };
        QVERIFY(next(true));
        QCOMPARE(number, 1);
        QVERIFY(!next(false));
        QCOMPARE(number, 2);
        QVERIFY(next(true));
        QCOMPARE(number, 2);
        QVERIFY(tables.database.run("DELETE FROM counters"));
        QVERIFY(next(true)); // the transaction goes on, and its work is told
        QCOMPARE(number, 0);
    }
};

DYNCAL_TEST(TestCertificateTable)
#include "tst_certificate_table.moc"
