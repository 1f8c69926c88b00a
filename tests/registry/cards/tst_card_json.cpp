// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_json.h"

#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using dyncal::test::isFitToShow;

/// Cards as JSON: what the window shows and gives back.
class TestCardJson : public QObject
{
    Q_OBJECT

private slots:
    void cards_comeBack()
    {
        const std::vector<Card> cards{
            {"sensor", "Acme 5", {{"sensor_model", "5"}, {"note", "a \"b\"\n,;"}}},
            {"sensor", "B", {}}};
        const auto read = parseCardsJson(cardsJson(cards), "sensor");
        QVERIFY(read && *read == cards);
        QVERIFY(parseCardsJson("[]", "sensor")->empty());
    }

    void hostileText_comesBack()
    {
        for (const std::string &text : test::hostileTexts()) {
            const std::vector<Card> cards{{"customer", "A", {{"note", text}}}};
            const auto read = parseCardsJson(cardsJson(cards), "customer");
            if (isFitToShow(text, LineBreaks::Keep)) // else it is no UTF-8 text to begin with
                QVERIFY(read && *read == cards);
        }
    }

    void emptyFields_areLeftOut()
    {
        const auto read
            = parseCardsJson(R"([{"name": "A", "fields": {"x": "", "y": "1"}}])", "customer");
        QVERIFY(read && read->front().fields.size() == 1);
    }

    void whatIsNoList_isRefused_data()
    {
        QTest::addColumn<QByteArray>("json");
        for (const char *json :
            {"", "{", "1", "[1]", "[{}]", R"([{"name": "A"}])", R"([{"name": 1, "fields": {}}])",
                R"([{"name": "A", "fields": {"x": 1}}])", R"([{"name": "", "fields": {}}])",
                R"([{"name": "A", "fields": {}}, {"name": "A", "fields": {}}])"})
            QTest::addRow("%s", json) << QByteArray(json);
    }
    void whatIsNoList_isRefused()
    {
        QFETCH(QByteArray, json);
        const auto read = parseCardsJson(json.toStdString(), "customer");
        QVERIFY(!read && read.error().kind == ErrorKind::Usage);
        QVERIFY(english(read.error().message).ends_with('.'));
    }

    void longName_isRefused()
    {
        const Card longest{"customer", std::string(200, 'a'), {}};
        QVERIFY(parseCardsJson(cardsJson({longest}), "customer"));
        const Card longer{"customer", std::string(201, 'a'), {}};
        QVERIFY(!parseCardsJson(cardsJson({longer}), "customer"));
    }
};

DYNCAL_TEST(TestCardJson)
#include "tst_card_json.moc"
