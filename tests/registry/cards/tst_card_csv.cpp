// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_csv.h"

#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

namespace {

std::vector<Card> someCards()
{
    return {{"customer", "Acme", {{"customer_address", "1 Street, Town"}, {"note", "say \"hi\""}}},
        {"customer", "B;C", {{"customer_address", "line 1\nline 2"}}}, {"customer", "D", {}}};
}

std::string whyNot(const std::string &csv)
{
    const auto cards = parseCards(csv, "customer");
    return cards ? "taken" : english(cards.error().message);
}

} // namespace

/// Cards as a table.
class TestCardCsv : public QObject
{
    Q_OBJECT

private slots:
    void table_isAsWritten()
    {
        QCOMPARE(cardsCsv(someCards()),
            "name,customer_address,note\n"
            "Acme,\"1 Street, Town\",\"say \"\"hi\"\"\"\n"
            "\"B;C\",\"line 1\nline 2\",\n"
            "D,,\n");
        QCOMPARE(cardsCsv({}), "name\n");
    }

    void cards_comeBack()
    {
        const auto read = parseCards(cardsCsv(someCards()), "customer");
        QVERIFY(read);
        QVERIFY(*read == someCards());
        QVERIFY(parseCards("name\n", "customer")->empty());
    }

    /// As a spreadsheet saves it.
    void otherForms_areRead()
    {
        const std::vector<Card> card{{"customer", "Acme", {{"a", "1, 2"}, {"b", "x"}}}};
        for (const char *csv :
            {"name,a,b\r\nAcme,\"1, 2\",x\r\n", "\xEF\xBB\xBFname;a;b\nAcme;1, 2;x\n",
                "a,name,b\n\"1, 2\",Acme,x", "name,a,b\nAcme,\"1, 2\",x\n,,\n\n"})
            QVERIFY2(parseCards(csv, "customer") == card, csv);
    }

    void formulas_areNoFormulas()
    {
        const std::vector<Card> cards{{"customer", "=1+1", {{"a", "@x"}, {"b", "-5"}}}};
        const std::string csv = cardsCsv(cards);
        QVERIFY(csv.find("'=1+1") != csv.npos);
        QVERIFY(*parseCards(csv, "customer") == cards);
    }

    void hostileTexts_stayInTheirCell()
    {
        for (const std::string &text : test::hostileTexts()) {
            const auto read = parseCards(
                cardsCsv({{"customer", "name", {{"a", text}, {"b", "after"}}}}), "customer");
            QVERIFY(read);
            QCOMPARE(read->size(), 1U);
            QCOMPARE(read->front().fields.at("b"), "after");
        }
    }

    void wrongTables_areRefusedWithTheLine()
    {
        QVERIFY(whyNot("").starts_with("Line 1 "));
        QVERIFY(whyNot("title,a\nx,1\n").starts_with("Line 1 "));
        QVERIFY(whyNot("name,name\nx,1\n").starts_with("Line 1 "));
        QVERIFY(whyNot("name,a\nx,1\ny\n").starts_with("Line 3 "));
        QVERIFY(whyNot("name,a\nx,1,2\n").starts_with("Line 2 "));
        QVERIFY(whyNot("name,a\n,1\n").starts_with("Line 2 "));
        QVERIFY(whyNot("name\nx\nx\n").starts_with("Line 3 "));
        QVERIFY(whyNot("name\n\"x\n").starts_with("Line 2 "));
        QVERIFY(whyNot("name\n" + std::string(201, 'x') + "\n").starts_with("Line 2 "));
    }
};

DYNCAL_TEST(TestCardCsv)
#include "tst_card_csv.moc"
