// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_register.h"

#include "registry/certificates/registry_check.h"
#include "registry/store/trail_table.h"
#include "tests/support/hostile_text.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

struct Laboratory
{
    ScratchFolder folder;
    CertificateRegister registry = openedRegister(folder.file("registry.sqlite"));

    Index put(const std::vector<Card> &cards)
    {
        return putCards(registry.database(), cards, "A. Berg", "from the old list", kNoon)
            .value_or(-1);
    }
    std::string fault()
    {
        const auto check = checkRegistry(registry);
        return check && check->firstDifference ? english(*check->firstDifference) : std::string();
    }
};

} // namespace

/// Cards in the registry.
class TestCardRegister : public QObject
{
    Q_OBJECT

private slots:
    void kinds_areFour()
    {
        for (const char *kind : {"laboratory", "customer", "sensor", "reference"})
            QVERIFY(isCardKind(kind));
        QVERIFY(!isCardKind("certificate") && !isCardKind(""));
    }

    void cards_comeBackByName()
    {
        Laboratory lab;
        const Card acme{"customer", "Acme", {{"customer_address", "1 Street"}}};
        const Card other{"customer", "A", {}}, sensor{"sensor", "Acme", {{"sensor_model", "5"}}};
        QCOMPARE(lab.put({acme, other, sensor}), 3);
        const auto customers = cardsOf(lab.registry.database(), "customer");
        QVERIFY((*customers == std::vector<Card>{other, acme}));
        QVERIFY(*findCard(lab.registry.database(), "sensor", "Acme") == sensor);
        QVERIFY(!*findCard(lab.registry.database(), "sensor", "none"));
        QCOMPARE(lab.fault(), std::string());
    }

    void changes_areInTheTrail()
    {
        Laboratory lab;
        Card card{"reference", "Pt100", {{"due", "2026-01-31"}}};
        QCOMPARE(lab.put({card}), 1);
        QCOMPARE(lab.put({card}), 0); // nothing new, no entry
        card.fields["due"] = "2027-01-31";
        QCOMPARE(lab.put({card}), 1);
        const auto entries = entriesOf(lab.registry.database(), "reference Pt100");
        QCOMPARE(entries->size(), 2U);
        QCOMPARE((*entries)[0].action, "added");
        QCOMPARE((*entries)[1].action, "changed");
        QCOMPARE((*entries)[1].before, R"({"due":"2026-01-31"})");
        QCOMPARE((*entries)[1].after, R"({"due":"2027-01-31"})");
        QCOMPARE((*entries)[1].who, "A. Berg");
        QCOMPARE((*entries)[1].reason, "from the old list");
        QCOMPARE(lab.fault(), std::string());
    }

    void tamperedCard_isFound()
    {
        Laboratory lab;
        QCOMPARE(lab.put({{"customer", "Acme", {{"a", "1"}}}, {"customer", "B", {}}}), 2);
        const auto run = [&](const char *statement) {
            return lab.registry.database().run(statement).has_value();
        };
        QVERIFY(run("UPDATE cards SET record = '{\"a\":\"2\"}' WHERE name = 'Acme'"));
        QCOMPARE(lab.fault(), "The row of customer Acme is not what the audit trail says of it.");
        QVERIFY(run("UPDATE cards SET record = '{\"a\":\"1\"}' WHERE name = 'Acme'"));
        QCOMPARE(lab.fault(), std::string());
        QVERIFY(run("DELETE FROM cards WHERE name = 'B'"));
        QCOMPARE(lab.fault(), "The row of customer B is missing.");
    }

    void hostileTexts_areKeptAsText()
    {
        Laboratory lab;
        for (const std::string &text : test::hostileTexts())
            QVERIFY(lab.put({{"sensor", text.substr(0, 150), {{text, text}}}}) >= 0);
        QCOMPARE(lab.fault(), std::string());
        QVERIFY(cardsOf(lab.registry.database(), "sensor"));
    }

    /// One that cannot be kept undoes all.
    void failure_changesNothing()
    {
        Laboratory lab;
        QVERIFY(lab.registry.database().run("DROP TABLE cards"));
        const auto before = allEntries(lab.registry.database());
        QCOMPARE(lab.put({{"customer", "Acme", {}}}), -1);
        QVERIFY(*allEntries(lab.registry.database()) == *before);
    }
};

DYNCAL_TEST(TestCardRegister)
#include "tst_card_register.moc"
