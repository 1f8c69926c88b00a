// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/nearest_word.h"
#include "tests/support/test_program.h"

#include <QTest>

using dyncal::editDistance;
using dyncal::nearestKey;

class TestNearestWord : public QObject
{
    Q_OBJECT

private slots:
    void editDistance_ofKnownPairs_data()
    {
        QTest::addColumn<QByteArray>("a");
        QTest::addColumn<QByteArray>("b");
        QTest::addColumn<int>("expected");
        QTest::newRow("equal") << QByteArray("order") << QByteArray("order") << 0;
        QTest::newRow("both empty") << QByteArray() << QByteArray() << 0;
        QTest::newRow("one empty") << QByteArray("abc") << QByteArray() << 3;
        QTest::newRow("textbook") << QByteArray("kitten") << QByteArray("sitting") << 3;
        QTest::newRow("weekend") << QByteArray("saturday") << QByteArray("sunday") << 3;
        QTest::newRow("one inserted") << QByteArray("ordr") << QByteArray("order") << 1;
    }

    void editDistance_ofKnownPairs()
    {
        QFETCH(QByteArray, a);
        QFETCH(QByteArray, b);
        QFETCH(int, expected);
        QCOMPARE(editDistance(a.toStdString(), b.toStdString()), dyncal::Index(expected));
        QCOMPARE(editDistance(b.toStdString(), a.toStdString()), dyncal::Index(expected));
    }

    void editDistance_ofHugeWords_isBounded()
    {
        const std::string huge(10000000, 'x');
        QCOMPARE(editDistance(huge, ""), dyncal::Index(64));
    }

    void nearestKey_prefersTheSameSection()
    {
        const std::vector<std::string> known{"window.end_s", "window.start", "input.end"};
        QCOMPARE(nearestKey("window.end", known), std::string("window.end_s"));
    }

    void nearestKey_findsAKeyInTheWrongSection()
    {
        const std::vector<std::string> known{"window.start", "realization", "realization.order"};
        QCOMPARE(nearestKey("order", known), std::string("realization.order"));
        QCOMPARE(nearestKey("window.order", known), std::string("realization.order"));
    }

    void nearestKey_ofNothing_isEmpty() { QCOMPARE(nearestKey("a", {}), std::string()); }
};

DYNCAL_TEST(TestNearestWord)
#include "tst_nearest_word.moc"
