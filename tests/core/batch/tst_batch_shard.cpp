// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_shard.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <vector>

using namespace dyncal;

/// Parts of a plan.
class TestBatchShard : public QObject
{
    Q_OBJECT

private slots:
    void parts_haveEverySensorOnce();
    void parts_areOfAboutTheSameSize();
    void nothing_isTheWhole();
    void words_areRead();
    void words_thatAreNone_data();
    void words_thatAreNone();
};

void TestBatchShard::parts_haveEverySensorOnce()
{
    for (std::size_t count = 1; count <= 23; ++count) {
        std::vector<int> times(50, 0);
        for (std::size_t number = 1; number <= count; ++number)
            for (std::size_t i = 0; i < times.size(); ++i)
                times[i] += BatchShard{number, count}.holds(i) ? 1 : 0;
        QVERIFY(std::ranges::all_of(times, [](int n) { return n == 1; }));
    }
}

void TestBatchShard::parts_areOfAboutTheSameSize()
{
    for (std::size_t number = 1; number <= 7; ++number) {
        std::size_t size = 0;
        for (std::size_t i = 0; i < 1000; ++i)
            size += BatchShard{number, 7}.holds(i) ? 1 : 0;
        QVERIFY(size == 142 || size == 143);
    }
}

void TestBatchShard::nothing_isTheWhole()
{
    const Result<BatchShard> shard = parseShard("");
    QVERIFY(shard);
    for (std::size_t i = 0; i < 10; ++i)
        QVERIFY(shard->holds(i));
}

void TestBatchShard::words_areRead()
{
    const Result<BatchShard> shard = parseShard("3/7");
    QVERIFY(shard);
    QCOMPARE(shard->number, std::size_t(3));
    QCOMPARE(shard->count, std::size_t(7));
    QVERIFY(parseShard("1/1"));
    QVERIFY(parseShard("1000000/1000000"));
}

void TestBatchShard::words_thatAreNone_data()
{
    QTest::addColumn<QByteArray>("word");
    for (const char *word : {"3", "/", "3/", "/7", "0/7", "8/7", "3/0", "-1/7", "+1/7", "1/7/2",
             "1 /7", "1/7 ", "1.5/7", "1/1000001", "99999999999999999999/7", "a/b", "1/7x"})
        QTest::newRow(word) << QByteArray(word);
}

void TestBatchShard::words_thatAreNone()
{
    QFETCH(QByteArray, word);
    const Result<BatchShard> shard = parseShard(word.toStdString());
    QVERIFY(!shard);
    QCOMPARE(shard.error().kind, ErrorKind::Usage);
    QVERIFY(
        english(shard.error().message).find('"' + word.toStdString() + '"') != std::string::npos);
}

DYNCAL_TEST(TestBatchShard)
#include "tst_batch_shard.moc"
