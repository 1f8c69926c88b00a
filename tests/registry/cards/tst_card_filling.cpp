// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_filling.h"

#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

namespace {

std::vector<Card> someCards()
{
    return {{"laboratory", "Lab", {{"laboratory_address", "1 Street"}, {"place", "hall 2"}}},
        {"customer", "Acme", {{"customer_address", "2 Street"}}},
        {"customer", "Bcme", {{"customer_address", "3 Street"}}},
        {"sensor", "S-17", {{"sensor_model", "P5"}, {"sensor_serial", "17"}}},
        {"reference", "Pt100",
            {{"quantity", "t1_k"}, {"certificate", "T-1"}, {"due", "2027-01-31"}}},
        {"reference", "Ruler", {{"quantity", "distance_m"}, {"certificate", "L-1"}}},
        {"reference", "Tape", {{"quantity", "distance_m"}, {"certificate", "L-2"}}}};
}

using Fields = std::map<std::string, std::string>;

Fields filled(const Fields &typed, const std::vector<Card> &cards = someCards())
{
    Recipe recipe;
    recipe.certificate.fields = typed;
    return filledFromCards(recipe, cards).certificate.fields;
}

} // namespace

/// What cards know and nobody has typed.
class TestCardFilling : public QObject
{
    Q_OBJECT

private slots:
    void onlyLaboratory_isTaken()
    {
        const Fields fields = filled({});
        QCOMPARE(fields.at("laboratory"), "Lab");
        QCOMPARE(fields.at("laboratory_address"), "1 Street");
        QCOMPARE(fields.at("place"), "hall 2");
        QVERIFY(!fields.contains("customer_address"));
    }

    void severalLaboratories_mustBeNamed()
    {
        auto cards = someCards();
        cards.push_back({"laboratory", "Other", {{"laboratory_address", "9 Street"}}});
        QVERIFY(filled({}, cards).empty());
        QCOMPARE(filled({{"laboratory", "Other"}}, cards).at("laboratory_address"), "9 Street");
        QVERIFY(!filled({{"laboratory", "third"}}, cards).contains("laboratory_address"));
    }

    void namedCustomerAndSensor_areTaken()
    {
        QCOMPARE(filled({{"customer", "Bcme"}}).at("customer_address"), "3 Street");
        QCOMPARE(filled({{"sensor_serial", "17"}}).at("sensor_model"), "P5");
        QCOMPARE(filled({{"sensor_serial", "S-17"}}).at("sensor_model"), "P5");
        QVERIFY(!filled({{"sensor_serial", "18"}}).contains("sensor_model"));
    }

    void typedTexts_stay()
    {
        const Fields typed{{"customer", "Acme"}, {"customer_address", "typed"}, {"place", " "}};
        QCOMPARE(filled(typed).at("customer_address"), "typed");
        QCOMPARE(filled(typed).at("place"), "hall 2"); // blanks are nothing typed
    }

    void references_fillTheBudget()
    {
        Recipe recipe;
        recipe.uncertainty.budget = {{.quantity = "t1_k", .u = 0.2},
            {.quantity = "distance_m", .u = 1e-4}, {.quantity = "p1_pa", .u = 50.0},
            {.quantity = "t1_k", .u = 0.2, .certificate = "typed"}};
        const auto budget = filledFromCards(recipe, someCards()).uncertainty.budget;
        QCOMPARE(budget[0].certificate, "T-1");
        QCOMPARE(budget[0].due, "2027-01-31");
        QCOMPARE(budget[0].u, 0.2);
        QCOMPARE(budget[1].certificate, ""); // two would do
        QCOMPARE(budget[2].certificate, "");
        QCOMPARE(budget[3].certificate, "typed");
        QCOMPARE(budget[3].due, "");
    }

    void withoutCards_nothingChanges() { QVERIFY(filledFromCards({}, {}) == Recipe()); }
};

DYNCAL_TEST(TestCardFilling)
#include "tst_card_filling.moc"
