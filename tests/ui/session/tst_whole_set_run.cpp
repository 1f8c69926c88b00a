// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/session/gated_pipeline.h"
#include "ui/session/whole_set_run.h"

#include <QtTest>

using namespace dyncal;

class TestWholeSetRun : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void started_isMadeOnceItIsThere();
    void otherOrder_doesNotStartItAnew();
    void otherSet_takesItsPlace();
    void cancelled_isNotDelivered_andWaitsUntilAllowed();
    void withheld_isOfOneSetOnly();
    void failed_isDeliveredAndNotMade();
    void forget_leavesNothing();

private:
    static std::string keyOf(const PipelineRequest &request)
    {
        return decompositionKey(*request.captures, request.recipe);
    }
    PipelineRequest otherSet() const
    {
        PipelineRequest other = m_runs.request();
        other.recipe.realization.maxOrder = m_runs.request().recipe.realization.maxOrder + 1;
        return other;
    }

    QObject m_receiver;
    GatedRuns m_runs;
    std::unique_ptr<WholeSetRun> m_run;
    int m_delivered = 0;
    int m_failed = 0;
};

void TestWholeSetRun::init()
{
    m_run.reset();
    m_runs = GatedRuns();
    m_delivered = m_failed = 0;
    m_run = std::make_unique<WholeSetRun>(
        &m_receiver,
        [this](const PipelineOutcome &outcome) {
            ++m_delivered;
            m_failed += outcome.error.has_value();
        },
        ProgressSink());
}

void TestWholeSetRun::started_isMadeOnceItIsThere()
{
    QVERIFY(m_run->start(m_runs.request()));
    QVERIFY(m_run->made().empty());
    m_runs.gate->open = true;
    QTRY_COMPARE(m_delivered, 1);
    QCOMPARE(m_run->made(), keyOf(m_runs.request()));
}

void TestWholeSetRun::otherOrder_doesNotStartItAnew()
{
    QVERIFY(m_run->start(m_runs.request(2)));
    QTRY_COMPARE(m_runs.gate->begun.load(), 1);
    for (const Index order : {3, 4, 5})
        QVERIFY(m_run->start(m_runs.request(order)));
    QTest::qWait(30);
    QCOMPARE(m_runs.gate->begun.load(), 1);
    QCOMPARE(m_runs.gate->stopped.load(), 0);
    m_runs.gate->open = true;
    QTRY_COMPARE(m_delivered, 1);
}

void TestWholeSetRun::otherSet_takesItsPlace()
{
    QVERIFY(m_run->start(m_runs.request()));
    QTRY_COMPARE(m_runs.gate->begun.load(), 1);
    QVERIFY(m_run->start(otherSet()));
    QTRY_COMPARE(m_runs.gate->stopped.load(), 1);
    m_runs.gate->open = true;
    QTRY_COMPARE(m_delivered, 1);
    QCOMPARE(m_run->made(), keyOf(otherSet()));
    QTest::qWait(30);
    QCOMPARE(m_delivered, 1);
}

void TestWholeSetRun::cancelled_isNotDelivered_andWaitsUntilAllowed()
{
    QVERIFY(m_run->start(m_runs.request()));
    QTRY_COMPARE(m_runs.gate->begun.load(), 1);
    m_run->cancel();
    m_run->withhold(keyOf(m_runs.request()));
    QTRY_COMPARE(m_runs.gate->stopped.load(), 1);
    QVERIFY(!m_run->start(m_runs.request(7)));
    QTest::qWait(30);
    QCOMPARE(m_runs.gate->begun.load(), 1);
    QCOMPARE(m_delivered, 0);
    QVERIFY(m_run->made().empty());
    m_runs.gate->open = true;
    m_run->allow();
    QVERIFY(m_run->start(m_runs.request()));
    QTRY_COMPARE(m_delivered, 1);
    QCOMPARE(m_failed, 0);
}

void TestWholeSetRun::withheld_isOfOneSetOnly()
{
    m_runs.gate->open = true;
    m_run->withhold(keyOf(m_runs.request()));
    QVERIFY(m_run->start(otherSet()));
    QTRY_COMPARE(m_delivered, 1);
}

void TestWholeSetRun::failed_isDeliveredAndNotMade()
{
    m_runs.gate->open = true;
    m_runs.gate->fails = true;
    QVERIFY(m_run->start(m_runs.request()));
    QTRY_COMPARE(m_failed, 1);
    QVERIFY(m_run->made().empty());
}

void TestWholeSetRun::forget_leavesNothing()
{
    m_runs.gate->open = true;
    QVERIFY(m_run->start(m_runs.request()));
    QTRY_COMPARE(m_delivered, 1);
    m_run->withhold(keyOf(m_runs.request()));
    m_run->forget();
    QVERIFY(m_run->made().empty());
    QVERIFY(m_run->start(m_runs.request()));
    QTRY_COMPARE(m_delivered, 2);
}

DYNCAL_TEST(TestWholeSetRun)
#include "tst_whole_set_run.moc"
