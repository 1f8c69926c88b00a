// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/core/base/writing/folder_snapshot.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/quick_recipe.h"
#include "tests/system/short_capture.h"

#include <filesystem>

using namespace dyncal::testing;
namespace fs = std::filesystem;

/// The built program on a disk that is full from its k-th write on, for every k up to the one that
/// no longer fails (system/full_disk): what was there stays, and one sentence says why.
class TestFullDisk : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_captures;
    QString m_first, m_second;

    QString simulated(const char *name, int seed)
    {
        const QString path = QString::fromStdString(m_captures.file(name));
        return simulateShortCapture(path, seed) ? path : QString();
    }

    static Answer runOnFullDisk(const QStringList &arguments, int from)
    {
        return runDyncal(arguments,
            {"SOURCE_DATE_EPOCH=1700000000",
                "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0", // where it is so built
                "LD_PRELOAD=" + qEnvironmentVariable("DYNCAL_FULL_DISK"),
                "DYNCAL_FULL_FROM=" + QString::number(from)});
    }

private slots:
    void initTestCase()
    {
        QVERIFY(QFile::exists(qEnvironmentVariable("DYNCAL_FULL_DISK")));
        m_first = simulated("a.h5", 1);
        m_second = simulated("b.h5", 2);
        QVERIFY(!m_first.isEmpty() && !m_second.isEmpty());
    }

    void everyWrite_data()
    {
        QTest::addColumn<QStringList>("verb");
        QTest::addColumn<bool>("ofCapture");
        QTest::addColumn<int>("shortStep");
        QTest::newRow("run") << QStringList{"run"} + quickly() << true << 23;
        QTest::newRow("export") << QStringList{"export"} + quickly() << true << 5;
        QTest::newRow("import") << QStringList{"import", "--replace"} << true << 7;
        QTest::newRow("simulate") << QStringList{"simulate", "--replace", "--preset", "piezo",
            "--duration-s", "0.003", "--shots", "low"}
                                  << false << 7;
    }

    void everyWrite()
    {
        QFETCH(QStringList, verb);
        QFETCH(bool, ofCapture);
        QFETCH(int, shortStep);
        const ScratchFolder place;
        const QString target = QString::fromStdString(place.file(ofCapture ? "out.h5" : "s.h5"));
        const auto call = [&](const QString &capture, const char *seed) {
            return verb + (ofCapture ? QStringList{capture} : QStringList{"--seed", seed})
                + QStringList{"-o", target};
        };
        constexpr int kNever = 1 << 30;
        QVERIFY(runOnFullDisk(call(m_first, "1"), kNever).exitCode <= 1);
        const Snapshot before = snapshotOf(place.file(""));
        const int step = dyncal::trials::count(shortStep, 1);
        int failed = 0;
        for (int from = 0;; from += step) {
            const Answer answer = runOnFullDisk(call(m_second, "2"), from);
            const QByteArray about = QByteArray::number(from) + ": " + answer.err;
            if (answer.exitCode == 0 || answer.exitCode == 1)
                break;
            ++failed;
            QVERIFY2(answer.exitCode == 5, about);
            QVERIFY2(answer.err.contains("space"), about);
            QVERIFY2(answer.err.count('\n') == 1 && answer.err.endsWith(".\n"), about);
            QVERIFY2(snapshotOf(place.file("")) == before, about);
            QVERIFY2(straysIn(place.file("")) == 0, about);
        }
        qInfo("%s: %d writes failed one after the other", QTest::currentDataTag(), failed);
        QVERIFY(failed > 0);
        QVERIFY(snapshotOf(place.file("")) != before);
        QVERIFY(runOnFullDisk(call(m_first, "1"), kNever).exitCode <= 1);
        QVERIFY(snapshotOf(place.file("")) == before);
        QCOMPARE(straysIn(place.file("")), 0);
    }
};

DYNCAL_TEST(TestFullDisk)
#include "tst_full_disk.moc"
