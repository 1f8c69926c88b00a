// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/base/writing/written_list.h"
#include "core/batch/batch_plan.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/system/batch_folder.h"

#include <QtTest>

#include <algorithm>

namespace {

constexpr const char *kProfile
    = R"({"schema": "dyncal-profile/1", "name": "L", "version": "%1", "shock": {"driver_length_m": 0.97}})";

/// Makes complete results those of another version of the model: whole, but of another key.
bool ageResults(const BatchFolder &batch, std::size_t sensor)
{
    const auto plan = dyncal::readPlan(batch.path("night.jsonl").toStdString());
    if (!plan)
        return false;
    dyncal::PlannedSensor older = (*plan)[sensor];
    const std::string key = dyncal::sensorKey(older);
    older.methods["model"] -= 1;
    const QString folder = batch.path(QString::fromStdString(older.output) + "/calibration/");
    const QByteArray record
        = bytesOf(folder + "batch.json").replace(key.c_str(), dyncal::sensorKey(older).c_str());
    auto list = dyncal::parseWrittenList(bytesOf(folder + "written.json").toStdString());
    if (!list)
        return false;
    const auto entry = std::ranges::find(*list, "batch.json", &dyncal::WrittenFile::file);
    entry->sha256 = dyncal::sha256Hex(record.toStdString());
    return writeBytes(folder + "batch.json", record)
        && writeBytes(
            folder + "written.json", QByteArray::fromStdString(dyncal::writtenListText(*list)));
}

} // namespace

/// What is computed again, and what is not: many sensors, other settings, other methods.
class TestBatchAgain : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_simulated;
    const int m_sensors = dyncal::trials::count(8, 1000);

private slots:
    void initTestCase()
    {
        for (int i = 1; i <= m_sensors; ++i)
            QVERIFY(simulateShortCapture(m_simulated.filePath(QString("%1.h5").arg(i)), i));
    }

    void parts_1_7_100_giveTheSameSummary();
    void changedProfile_isComputedAgain();
    void olderMethod_isComputedAgainAlone();
};

/// Bytes of the summary, and what one number of parts computed is complete for the others.
void TestBatchAgain::parts_1_7_100_giveTheSameSummary()
{
    QByteArray expected;
    for (const int parts : {1, 7, 100}) {
        const BatchFolder batch;
        batch.addSensors(m_simulated.path(), m_sensors);
        QCOMPARE(batch.plan().exitCode, 0);
        for (int part = 1; part <= parts; ++part)
            QVERIFY(batch.run({"--shard", QString("%1/%2").arg(part).arg(parts), "--jobs", "2"})
                        .exitCode
                <= 1);
        const QByteArray summary = batch.summary();
        QCOMPARE(summary.count('\n'), m_sensors + 1);
        if (parts == 1)
            expected = summary;
        QCOMPARE(summary, expected);
        const Answer again = batch.run();
        const QByteArray kept = "Computed 0, kept " + QByteArray::number(m_sensors) + '\n';
        QVERIFY2(again.out.endsWith(kept), again.out.constData());
    }
}

void TestBatchAgain::changedProfile_isComputedAgain()
{
    const BatchFolder batch;
    batch.addSensors(m_simulated.path(), 3);
    const QByteArray profile(kProfile);
    QVERIFY(writeBytes(batch.path("profile.json"), QByteArray(profile).replace("%1", "1")));
    const QStringList with{"--profile", batch.path("profile.json")};
    QCOMPARE(batch.plan(with).exitCode, 0);
    QVERIFY(batch.run().out.endsWith("Computed 3, kept 0\n"));
    QCOMPARE(batch.plan(with).exitCode, 0);
    QVERIFY(batch.run().out.endsWith("Computed 0, kept 3\n"));
    QVERIFY(writeBytes(batch.path("profile.json"), QByteArray(profile).replace("%1", "2")));
    const Answer unplanned = batch.run();
    QCOMPARE(unplanned.exitCode, 2);
    QCOMPARE(batch.status()["failed"].toInt(), 3);
    QCOMPARE(batch.plan(with).exitCode, 0);
    QVERIFY(batch.run().out.endsWith("Computed 3, kept 0\n"));
}

void TestBatchAgain::olderMethod_isComputedAgainAlone()
{
    const BatchFolder batch;
    batch.addSensors(m_simulated.path(), 3);
    QCOMPARE(batch.plan().exitCode, 0);
    QVERIFY(batch.run().out.endsWith("Computed 3, kept 0\n"));
    const QByteArray summary = batch.summary();
    const auto before = filesBelow(batch.path("night.out"));
    QVERIFY(ageResults(batch, 1));
    QCOMPARE(batch.status()["missing"].toInt(), 1);
    const Answer again = batch.run();
    QVERIFY2(again.out.endsWith("Computed 1, kept 2\n"), again.out.constData());
    QVERIFY2(!again.err.contains("damaged"), again.err.constData());
    const auto after = filesBelow(batch.path("night.out"));
    QCOMPARE(after.size(), before.size());
    for (auto file = before.begin(); file != before.end(); ++file)
        QCOMPARE(after[file.key()] == file.value(), !file.key().startsWith("SN-2/"));
    QCOMPARE(batch.summary(), summary);
}

DYNCAL_TEST(TestBatchAgain)
#include "tst_batch_again.moc"
