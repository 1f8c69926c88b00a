// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_country.h"
#include "core/dcc/iso_codes.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

Recipe with(const std::map<std::string, std::string> &fields)
{
    Recipe recipe;
    recipe.certificate.fields = fields;
    return recipe;
}

} // namespace

/// Where laboratory and customer are, for a DCC, and what is said where nobody has.
class TestDccCountry : public QObject
{
    Q_OBJECT

private slots:
    void typedCode_comesBeforeTheAddress_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("address");
        QTest::addColumn<QString>("country");
        const auto row = [](const char *typed, const char *address, const char *country) {
            QTest::addRow("%s, %s", typed, address) << typed << address << country;
        };
        row("SE", "1 Test Street", "SE");
        row(" SE\n", "DK-2800 Lyngby", "SE");
        row("", "DK-2800 Lyngby", "DK");
        row("", "2800 Lyngby, DK", "DK");
        row("Sweden", "DK-2800 Lyngby", "DK");
        row("se", "", kNoCountry);
        row("ZZ", "", kNoCountry);
        row("", "1 Test Street", kNoCountry);
    }
    void typedCode_comesBeforeTheAddress()
    {
        QFETCH(QString, typed);
        QFETCH(QString, address);
        QFETCH(QString, country);
        const Recipe recipe = with({{"customer_country", typed.toStdString()},
            {"customer_address", address.toStdString()}, {"laboratory_country", "FR"}});
        QCOMPARE(dccCountry(recipe, "customer"), country.toStdString());
        QCOMPARE(dccCountry(recipe, "laboratory"), std::string("FR"));
    }

    void missingOnes_areCautions_oneEach()
    {
        const Findings both = countryCautions(Recipe());
        QCOMPARE(both.size(), std::size_t(2));
        for (const Finding &one : both) {
            QCOMPARE(one.id, std::string("CER-010"));
            QCOMPARE(one.severity, Severity::Caution);
        }
        QVERIFY(english(both[0].message).find("of the laboratory") != std::string::npos);
        QVERIFY(english(both[1].message).find("of the customer") != std::string::npos);
        const Findings one
            = countryCautions(with({{"laboratory_address", "SE-501 15 Bor\u00e5s"}}));
        QCOMPARE(one, Findings{both[1]});
        QVERIFY(countryCautions(with({{"laboratory_country", "SE"}, {"customer_country", "NO"}}))
                    .empty());
    }
};

DYNCAL_TEST(TestDccCountry)
#include "tst_dcc_country.moc"
