// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/iso_codes.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestIsoCodes : public QObject
{
    Q_OBJECT

private slots:
    void code_isOneOfTheList()
    {
        for (const char *country : {"SE", "DE", "AD", "ZW", "CH"})
            QVERIFY2(isCountryCode(country), country);
        for (const char *none : {"ZZ", "se", "S", "", "SWE", "E ", "UK", "D A"})
            QVERIFY2(!isCountryCode(none), none);
        for (const char *language : {"en", "sv", "de", "aa", "zu"})
            QVERIFY2(isLanguageCode(language), language);
        for (const char *none : {"EN", "xx", "", "eng", "n "})
            QVERIFY2(!isLanguageCode(none), none);
    }

    void addressWithACode_hasItsCountry_data()
    {
        QTest::addColumn<QString>("address");
        QTest::addColumn<QString>("country");
        QTest::newRow("post code") << "Brinellgatan 4, SE-504 62 Bor\u00e5s"
                                   << "SE";
        QTest::newRow("post code in a line of its own") << "Bundesallee 100\nDE-38116 Braunschweig"
                                                        << "DE";
        QTest::newRow("last word") << "1 Test Street, Oslo, NO"
                                   << "NO";
        QTest::newRow("name only") << "Brinellgatan 4, 504 62 Bor\u00e5s, Sweden"
                                   << "ZZ";
        QTest::newRow("a direction, not a country") << "12 NE Street, Portland"
                                                    << "ZZ";
        QTest::newRow("no such country") << "XX-123 Nowhere"
                                         << "ZZ";
        QTest::newRow("empty") << ""
                               << "ZZ";
    }
    void addressWithACode_hasItsCountry()
    {
        QFETCH(QString, address);
        QFETCH(QString, country);
        QCOMPARE(QString::fromStdString(countryOf(address.toStdString())), country);
    }
};

DYNCAL_TEST(TestIsoCodes)
#include "tst_iso_codes.moc"
