// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/foreign_text.h"
#include "core/base/portable_random.h"
#include "core/base/text_encoding.h"
#include "core/batch/sensor_name.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <map>

using namespace dyncal;

/// Folder names of sensors: readable, safe, another one for every id.
class TestSensorName : public QObject
{
    Q_OBJECT

private slots:
    void plainNames_stay_data();
    void plainNames_stay();
    void others_areWrittenOut_data();
    void others_areWrittenOut();
    void longNames_areCutBetweenCharacters();
    void names_areDifferentForDifferentIds();
    void names_leadNowhere();
};

void TestSensorName::plainNames_stay_data()
{
    QTest::addColumn<QByteArray>("id");
    for (const char *id :
        {"SN-0012", "a", "2026_11.h5", "Ödmjuk", "センサー", "x-", "a.b-c_d,e=f@g"})
        QTest::newRow(id) << QByteArray(id);
}

void TestSensorName::plainNames_stay()
{
    QFETCH(QByteArray, id);
    QCOMPARE(sensorFolderName(id.toStdString()), id.toStdString());
}

void TestSensorName::others_areWrittenOut_data()
{
    QTest::addColumn<QByteArray>("id");
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("deeper") << QByteArray("2026/SN-1") << QByteArray("2026+SN-1");
    QTest::newRow("plus") << QByteArray("a+b") << QByteArray("a%2Bb");
    QTest::newRow("percent") << QByteArray("a%2Bb") << QByteArray("a%252Bb");
    QTest::newRow("blank") << QByteArray("a b") << QByteArray("a%20b");
    QTest::newRow("hidden") << QByteArray(".a/.b") << QByteArray("%2Ea+.b");
    QTest::newRow("option") << QByteArray("-rf") << QByteArray("%2Drf");
    QTest::newRow("shell") << QByteArray("$(x)`y`") << QByteArray("%24(x)%60y%60");
    QTest::newRow("control") << QByteArray("a\nb\x7f") << QByteArray("a%0Ab%7F");
}

void TestSensorName::others_areWrittenOut()
{
    QFETCH(QByteArray, id);
    QFETCH(QByteArray, name);
    QCOMPARE(sensorFolderName(id.toStdString()), name.toStdString());
}

void TestSensorName::longNames_areCutBetweenCharacters()
{
    for (int before = 0; before < 4; ++before) {
        std::string id(static_cast<std::size_t>(before), 'x');
        for (int i = 0; i < 100; ++i)
            id += "\u30bb";
        const std::string name = sensorFolderName(id);
        QVERIFY(name.size() <= 150);
        QVERIFY(name.size() > 140);
        QVERIFY(isUtf8(name));
        QVERIFY(name != sensorFolderName(id + "x"));
        QCOMPARE(name, sensorFolderName(id));
    }
    QCOMPARE(sensorFolderName(std::string(150, 'a')), std::string(150, 'a'));
    QCOMPARE(sensorFolderName(std::string(151, 'a')).size(), std::size_t(150));
}

/// Ids of few characters, all of them special in some way, so that names could meet.
void TestSensorName::names_areDifferentForDifferentIds()
{
    constexpr std::string_view kCharacters = "/+%2BF.-~a ";
    RandomStream random(20261, 0, 0);
    std::map<std::string, std::string> idOf;
    for (int trial = 0; trial < 20000; ++trial) {
        std::string id;
        const int length = 1 + static_cast<int>(random.nextUniform() * 5.0);
        for (int i = 0; i < length; ++i)
            id += kCharacters[static_cast<std::size_t>(
                random.nextUniform() * static_cast<double>(kCharacters.size()))];
        const auto [place, isNew] = idOf.emplace(sensorFolderName(id), id);
        QVERIFY2(isNew || place->second == id, (place->second + " and " + id).c_str());
    }
}

void TestSensorName::names_leadNowhere()
{
    for (const char *id : {"..", ".", "../x", "a/../../x", "/", "/etc", "a/", "\\x", "~root"}) {
        const std::string name = sensorFolderName(id);
        QVERIFY(!name.empty());
        QVERIFY2(name.find('/') == std::string::npos, name.c_str());
        QVERIFY2(!name.starts_with('.') && !name.starts_with('~'), name.c_str());
        QCOMPARE(presentable(name), name);
    }
}

DYNCAL_TEST(TestSensorName)
#include "tst_sensor_name.moc"
