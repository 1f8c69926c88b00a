// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/session/gated_pipeline.h"
#include "ui/session/rest_run.h"

#include <QElapsedTimer>
#include <QtTest>

using namespace dyncal;

class TestRestRun : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void singleChange_beginsAtOnce();
    void series_waitsForTheHand();
    void hurry_beginsAtOnce_onlyIfAsked();
    void withdraw_beginsNothing();
    void parts_comeBeforeTheWhole();
    void focusOnTheResponse_isNotDeliveredAgain();
    void newerWork_stopsIt();

private:
    void ask(bool isSeries)
    {
        m_asked.start();
        m_run->ask(isSeries);
    }
    void start(StageId focus)
    {
        m_run->start(
            &m_receiver, m_runs.request(), focus,
            [this](const CalibrationResults &, StageId upTo, bool isFirstTriplets) {
                QVERIFY(!isFirstTriplets);
                QVERIFY(!m_isWhole);
                m_parts << upTo;
            },
            [this](const RunPart &part) {
                QVERIFY(!part.outcome.error);
                m_isWhole = true;
            },
            {});
    }

    QObject m_receiver;
    GatedRuns m_runs;
    std::unique_ptr<JobRunner> m_jobs;
    std::unique_ptr<RestRun> m_run;
    QElapsedTimer m_asked;
    QVector<qint64> m_waits_ms; ///< from the last ask to every begin
    QVector<StageId> m_parts;
    bool m_isWhole = false;
};

void TestRestRun::init()
{
    m_run.reset();
    m_runs = GatedRuns();
    m_waits_ms.clear();
    m_parts.clear();
    m_isWhole = false;
    m_jobs = std::make_unique<JobRunner>(&m_receiver, 2);
    m_run = std::make_unique<RestRun>(*m_jobs, [this] { m_waits_ms << m_asked.elapsed(); });
}

void TestRestRun::singleChange_beginsAtOnce()
{
    ask(false);
    QTRY_COMPARE(m_waits_ms.size(), 1);
    QVERIFY2(m_waits_ms[0] < 120, qPrintable(QString::number(m_waits_ms[0])));
}

void TestRestRun::series_waitsForTheHand()
{
    for (int move = 0; move < 4; ++move) {
        ask(true);
        QTest::qWait(40); // the hand moves on
    }
    QTRY_VERIFY(!m_waits_ms.isEmpty());
    for (const qint64 wait_ms : m_waits_ms) // one, unless this machine has rested itself
        QVERIFY2(wait_ms >= 130, qPrintable(QString::number(wait_ms)));
}

void TestRestRun::hurry_beginsAtOnce_onlyIfAsked()
{
    m_run->hurry();
    QTest::qWait(30);
    QVERIFY(m_waits_ms.isEmpty());
    ask(true);
    m_run->hurry();
    QTRY_COMPARE(m_waits_ms.size(), 1);
    QVERIFY2(m_waits_ms[0] < 120, qPrintable(QString::number(m_waits_ms[0])));
}

void TestRestRun::withdraw_beginsNothing()
{
    ask(false);
    m_run->withdraw();
    QTest::qWait(200);
    QVERIFY(m_waits_ms.isEmpty());
}

void TestRestRun::parts_comeBeforeTheWhole()
{
    m_runs.gate->open = true;
    start(StageId::Shock);
    QTRY_VERIFY(m_isWhole);
    QCOMPARE(
        m_parts, (QVector<StageId>{StageId::Response, StageId::Assessment, StageId::Evidence}));
}

void TestRestRun::focusOnTheResponse_isNotDeliveredAgain()
{
    m_runs.gate->open = true;
    start(StageId::Response);
    QTRY_VERIFY(m_isWhole);
    QCOMPARE(m_parts, (QVector<StageId>{StageId::Assessment, StageId::Evidence}));
}

void TestRestRun::newerWork_stopsIt()
{
    start(StageId::Shock);
    QTRY_COMPARE(m_runs.gate->begun.load(), 1);
    m_jobs->start<int>([](const JobControl &) -> Result<int> { return 0; }, [](Result<int>) {});
    QTRY_COMPARE(m_runs.gate->stopped.load(), 1);
    m_runs.gate->open = true;
    QTest::qWait(30);
    QVERIFY(m_parts.isEmpty());
    QVERIFY(!m_isWhole);
}

DYNCAL_TEST(TestRestRun)
#include "tst_rest_run.moc"
