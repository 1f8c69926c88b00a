// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/session/gated_pipeline.h"
#include "ui/session/focus_run.h"

#include <QElapsedTimer>
#include <QtTest>

#include <optional>

using namespace dyncal;

class TestFocusRun : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void ask_manyTimes_beginsOnceWhenAllIsSaid();
    void withdraw_beginsNothing();
    void start_newest_isDelivered();
    void youngRun_isLetFinish_thenANewerBegins();
    void finishedRun_mayBeFollowedAtOnce();
    void otherWork_onTheSameJobs_isNotWaitedFor();

private:
    void start(Index order)
    {
        m_run->start(m_runs.request(order), StageId::Shock,
            [this](const RunPart &part, StageId upTo) {
                QCOMPARE(upTo, StageId::Shock);
                m_delivered << part.outcome.results.model->order;
            },
            {});
    }

    QObject m_receiver;
    GatedRuns m_runs;
    std::unique_ptr<JobRunner> m_jobs;
    std::unique_ptr<FocusRun> m_run;
    int m_begun = 0;
    QVector<Index> m_delivered;
};

void TestFocusRun::init()
{
    m_run.reset();
    m_runs = GatedRuns();
    m_begun = 0;
    m_delivered.clear();
    m_jobs = std::make_unique<JobRunner>(&m_receiver, 2);
    m_run = std::make_unique<FocusRun>(*m_jobs, [this] { ++m_begun; });
}

void TestFocusRun::ask_manyTimes_beginsOnceWhenAllIsSaid()
{
    m_run->ask();
    m_run->ask();
    QVERIFY(m_run->isAsked());
    QCOMPARE(m_begun, 0);
    QTRY_COMPARE(m_begun, 1);
    QVERIFY(!m_run->isAsked());
    QTest::qWait(30);
    QCOMPARE(m_begun, 1);
}

void TestFocusRun::withdraw_beginsNothing()
{
    m_run->ask();
    m_run->withdraw();
    QTest::qWait(30);
    QCOMPARE(m_begun, 0);
}

void TestFocusRun::start_newest_isDelivered()
{
    start(3);
    QTRY_COMPARE(m_runs.gate->begun.load(), 1);
    start(4);
    QTRY_COMPARE(m_runs.gate->stopped.load(), 1);
    m_runs.gate->open = true;
    QTRY_COMPARE(m_delivered, QVector<Index>{4});
    QTest::qWait(30);
    QCOMPARE(m_delivered, QVector<Index>{4});
    QCOMPARE(m_run->focus(), StageId::Shock);
}

void TestFocusRun::youngRun_isLetFinish_thenANewerBegins()
{
    QElapsedTimer clock;
    start(3);
    clock.start();
    QVERIFY(!m_run->mayBegin());
    QVERIFY(m_run->isAsked()); // by itself
    QTRY_COMPARE(m_begun, 1);
    QVERIFY2(clock.elapsed() >= 500, qPrintable(QString::number(clock.elapsed())));
    QTRY_VERIFY(m_run->mayBegin());
    QCOMPARE(m_runs.gate->stopped.load(), 0); // until a newer one is started
}

void TestFocusRun::finishedRun_mayBeFollowedAtOnce()
{
    m_runs.gate->open = true;
    start(3);
    QTRY_COMPARE(m_delivered, QVector<Index>{3});
    QVERIFY(m_run->mayBegin());
    QVERIFY(!m_run->isAsked());
}

void TestFocusRun::otherWork_onTheSameJobs_isNotWaitedFor()
{
    start(3);
    m_jobs->start<int>(
        [](const JobControl &control) -> Result<int> {
            while (!control.stopRequested())
                QThread::msleep(1);
            return 0;
        },
        [](Result<int>) {});
    QVERIFY(m_jobs->isRunning());
    QVERIFY(m_run->mayBegin());
    m_runs.gate->open = true;
    QTest::qWait(30);
    QVERIFY(m_delivered.isEmpty()); // it was stopped by the other
}

DYNCAL_TEST(TestFocusRun)
#include "tst_focus_run.moc"
