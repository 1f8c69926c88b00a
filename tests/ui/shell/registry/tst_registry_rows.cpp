// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/shell/registry/registry_caller.h"
#include "ui/shell/registry/registry_rows.h"
#include "ui/shell/registry/rows_view.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QtTest>

using namespace dyncal;

/// What commands on the registry print, as rows; and the table that shows them.
class TestRegistryRows : public QObject
{
    Q_OBJECT

private:
    static std::vector<QVariantList> numbered(int count)
    {
        std::vector<QVariantList> rows;
        for (int i = 1; i <= count; ++i)
            rows.push_back({i, QString("row %1").arg(i)});
        return rows;
    }
    static QAbstractItemModel *model(RowsView &view)
    {
        return view.findChild<QTableView *>("rows")->model();
    }

private slots:
    void certificate_isARow()
    {
        const QJsonArray list = listOf(R"([{"number": 17, "state": "replaced", "sensor": "Acme",
            "customer": "C", "issued_utc": "2026-01-31T12:00:00Z", "by": "A", "reviewed_by": "B",
            "amends": 0, "replaced_by": 18, "reason": "r"}])");
        const auto rows = certificateRows(list);
        QCOMPARE(rows.size(), std::size_t(1));
        const QVariantList expected{qint64(17), "replaced", "Acme", "C", "2026-01-31 12:00:00", "A",
            "B", QVariant(), qint64(18), "r"};
        QCOMPARE(rows.front(), expected);
    }

    void everyState_hasAWord()
    {
        QStringList words;
        for (const char *state : {"reserved", "issued", "amended", "replaced", "withdrawn", "void"})
            words << certificateStateText(state);
        QCOMPARE(words.removeDuplicates(), 0);
        QVERIFY(!words.contains(QString()));
        QCOMPARE(certificateStateText("of later versions"), QString("of later versions"));
    }

    void verified_saysWhoSignedAndWhen()
    {
        const auto rows = verifiedRows(listOf(R"([
            {"file": "1", "kind": "certificate", "status": "unknown-signer", "number": 1,
             "state": "issued", "first_difference": null, "remarks": ["r."], "signer": "Lab",
             "signed_utc": "2026-01-31T12:00:00Z", "stamped_utc": "2026-01-31T12:00:05Z"}])"));
        const QVariantList expected{"1", "certificate", "▲ unknown signer", qint64(1), "issued",
            "Lab", "2026-01-31 12:00:00", "2026-01-31 12:00:05", "r."};
        QCOMPARE(rows.front(), expected);
    }

    void everyStatus_isValidBadOrDoubtful()
    {
        const VerifiedCounts counts = countsOf(listOf(R"([{"status": "valid"},
            {"status": "unsigned"}, {"status": "unknown-signer"}, {"status": "expired"},
            {"status": "changed"}, {"status": "missing"}, {"status": "unreadable"},
            {"status": "of later versions"}, 7])"));
        QCOMPARE(counts.valid, 1);
        QCOMPARE(counts.bad, 3);
        QCOMPARE(counts.doubtful, 5); // what is not known is not called valid
    }

    void verified_saysTheFirstDifferenceOrTheRemarks()
    {
        const auto rows = verifiedRows(listOf(R"([
            {"file": "1", "kind": "certificate", "status": "changed", "number": 1, "state": null,
             "first_difference": "recipe.json is changed.", "remarks": ["not signed."]},
            {"file": "r", "kind": "registry", "status": "valid", "number": null, "state": null,
             "first_difference": null, "remarks": ["a.", "b."]}])"));
        QCOMPARE(rows[0][8].toString(), QString("recipe.json is changed."));
        QCOMPARE(rows[0][2].toString(), QString("■ changed"));
        QCOMPARE(rows[1][8].toString(), QString("a. b."));
        QVERIFY(rows[1][3].isNull());
    }

    void trail_isInTheLanguageOfTheWindow()
    {
        const QByteArray entries = R"([
            {"sequence": 1, "action": "reserved", "object": "certificate 7"},
            {"sequence": 2, "action": "added", "object": "customer Acme & Co"},
            {"sequence": 3, "action": "of later versions", "object": "reference A 1"}])";
        const auto rows = trailRows(listOf(entries));
        QCOMPARE(rows[0][4].toString(), QString("certificate 7"));
        QCOMPARE(rows[2][3].toString(), QString("of later versions"));
        QCOMPARE(rows[2][4].toString(), QString("reference instrument A 1"));
        const test::InSwedish swedish;
        const auto inSwedish = trailRows(listOf(entries));
        QCOMPARE(inSwedish[0][4].toString(), QString("bevis 7"));
        QCOMPARE(inSwedish[1][3].toString(), QString("tillagt"));
        QCOMPARE(inSwedish[1][4].toString(), QString("kund Acme & Co"));
        for (int row : {0, 1})
            QVERIFY(inSwedish[row][3] != rows[row][3]);
    }

    void whatIsNoList_hasNoRows()
    {
        for (const char *json : {"", "x", "{}", "7", "\xff"})
            QVERIFY(certificateRows(listOf(json)).empty());
        QCOMPARE(trailRows(listOf("[1, null, {}]")).size(), std::size_t(3)); // and no crash
    }

    void hostileText_isFitToShow()
    {
        for (const std::string &text : test::hostileTexts()) {
            const QJsonArray list{QJsonObject{{"sequence", 1},
                {"utc", QString::fromStdString(text)}, {"who", QString::fromStdString(text)},
                {"action", QString::fromStdString(text)}, {"object", QString::fromStdString(text)},
                {"reason", QString::fromStdString(text)}}};
            const auto rows = trailRows(list);
            for (const QVariant &cell : rows.front())
                QVERIFY2(test::isFitToShow(cell.toString().toStdString()), text.c_str());
        }
    }

    void table_sortsNumbersAsNumbers()
    {
        RowsView view("rows", nullptr);
        view.setTitles({"Number", "Text"}, "rows");
        view.setRows(numbered(12));
        QCOMPARE(model(view)->index(0, 0).data().toInt(), 12); // the newest first, not "9"
        QCOMPARE(view.selected(), -1);
        view.findChild<QTableView *>("rows")->selectRow(0);
        QCOMPARE(view.selected(), 11); // its position as given
    }

    void search_leavesWhatHoldsTheText()
    {
        RowsView view("rows", nullptr);
        view.setTitles({"Number", "Text"}, "rows");
        view.setRows(numbered(12));
        view.findChild<QLineEdit *>("rowsText")->setText("ROW 1");
        QCOMPARE(model(view)->rowCount(), 4); // 1, 10, 11, 12
        QCOMPARE(view.findChild<QLabel *>("rowsCount")->text(), QString("4 of 12"));
        view.findChild<QLineEdit *>("rowsText")->setText(".*");
        QCOMPARE(model(view)->rowCount(), 0); // a text, no pattern
    }

    void selection_goesWithTheRows()
    {
        RowsView view("rows", nullptr);
        view.setTitles({"Number", "Text"}, "rows");
        view.setRows(numbered(3));
        view.findChild<QTableView *>("rows")->selectRow(1);
        QSignalSpy changed(&view, &RowsView::selectionChanged);
        view.setRows(numbered(2));
        QVERIFY(changed.size() >= 1);
        QCOMPARE(view.selected(), -1);
    }

    void password_isLeftOut()
    {
        QCOMPARE(withoutPassword("postgresql://u:p@h:1/d"), QString("postgresql://u@h:1/d"));
        QCOMPARE(withoutPassword("postgresql://u@h/d"), QString("postgresql://u@h/d"));
        QCOMPARE(withoutPassword("/a folder/r:x@y.sqlite"), QString("/a folder/r:x@y.sqlite"));
        QCOMPARE(withoutPassword({}), QString());
    }
};

DYNCAL_TEST(TestRegistryRows)
#include "tst_registry_rows.moc"
