// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/job_runner.h"

#include <QThread>
#include <QtTest>

#include <atomic>

using namespace dyncal;

class TestJobRunner : public QObject
{
    Q_OBJECT

private slots:
    void result_whenDone_arrivesOnTheReceiversThread();
    void start_whileRunning_deliversOnlyTheNewest();
    void cancel_dropsTheResultAndAsksTheJobToStop();
    void exception_becomesInternalError();
    void lackOfMemory_becomesInternalError();
    void destructor_stopsAndWaits();
    void progress_isThrottled();
};

void TestJobRunner::result_whenDone_arrivesOnTheReceiversThread()
{
    QObject receiver;
    JobRunner runner(&receiver);
    QThread *deliveredOn = nullptr;
    std::atomic<QThread *> workedOn = nullptr;
    int value = 0;
    runner.start<int>(
        [&](const JobControl &) -> Result<int> {
            workedOn = QThread::currentThread();
            return 42;
        },
        [&](Result<int> result) {
            deliveredOn = QThread::currentThread();
            value = *result;
        });
    QVERIFY(runner.isRunning());
    QTRY_COMPARE(value, 42);
    QCOMPARE(deliveredOn, QThread::currentThread());
    QVERIFY(workedOn.load() != QThread::currentThread());
    QVERIFY(!runner.isRunning());
}

void TestJobRunner::start_whileRunning_deliversOnlyTheNewest()
{
    QObject receiver;
    JobRunner runner(&receiver);
    QVector<int> delivered;
    for (int i = 0; i < 5; ++i)
        runner.start<int>(
            [i](const JobControl &) -> Result<int> {
                QThread::msleep(5);
                return i;
            },
            [&](Result<int> result) { delivered << *result; });
    QTRY_COMPARE(delivered, QVector<int>{4});
    QTest::qWait(60); // nothing comes after
    QCOMPARE(delivered, QVector<int>{4});
}

void TestJobRunner::cancel_dropsTheResultAndAsksTheJobToStop()
{
    QObject receiver;
    JobRunner runner(&receiver);
    std::atomic<bool> stopped = false;
    std::atomic<bool> begun = false;
    bool delivered = false;
    runner.start<int>(
        [&](const JobControl &control) -> Result<int> {
            begun = true;
            while (!control.stopRequested())
                QThread::msleep(1);
            stopped = true;
            return 1;
        },
        [&](Result<int>) { delivered = true; });
    QTRY_VERIFY(begun);
    runner.cancel();
    QVERIFY(!runner.isRunning());
    QTRY_VERIFY(stopped);
    QTest::qWait(20);
    QVERIFY(!delivered);
}

void TestJobRunner::exception_becomesInternalError()
{
    QObject receiver;
    JobRunner runner(&receiver);
    std::optional<Error> error;
    runner.start<int>([](const JobControl &) -> Result<int> { throw std::runtime_error("boom"); },
        [&](Result<int> result) { error = result.error(); });
    QTRY_VERIFY(error);
    QCOMPARE(error->kind, ErrorKind::Internal);
    QVERIFY(english(error->message).find("boom") != std::string::npos);
}

void TestJobRunner::lackOfMemory_becomesInternalError()
{
    QObject receiver;
    JobRunner runner(&receiver);
    std::optional<Error> error;
    runner.start<int>([](const JobControl &) -> Result<int> { throw std::bad_alloc(); },
        [&](Result<int> result) { error = result.error(); });
    QTRY_VERIFY(error);
    QCOMPARE(error->kind, ErrorKind::Internal);
    QVERIFY(english(error->message).find("memory") != std::string::npos);
}

void TestJobRunner::destructor_stopsAndWaits()
{
    QObject receiver;
    std::atomic<bool> ended = false;
    std::atomic<bool> begun = false;
    bool delivered = false;
    {
        JobRunner runner(&receiver);
        runner.start<int>(
            [&](const JobControl &control) -> Result<int> {
                begun = true;
                while (!control.stopRequested())
                    QThread::msleep(1);
                ended = true;
                return 1;
            },
            [&](Result<int>) { delivered = true; });
        QTRY_VERIFY(begun);
    }
    QVERIFY(ended);
    QTest::qWait(20);
    QVERIFY(!delivered);
}

void TestJobRunner::progress_isThrottled()
{
    QObject receiver;
    JobRunner runner(&receiver);
    int reports = 0;
    bool done = false;
    runner.start<int>(
        [](const JobControl &control) -> Result<int> {
            for (int i = 0; i < 250; ++i) {
                control.report(i / 250.0);
                QThread::msleep(1);
            }
            return 0;
        },
        [&](Result<int>) { done = true; }, [&](double) { ++reports; });
    QTRY_VERIFY(done);
    QVERIFY(reports >= 1);
    // A quarter of a second at ten a second; slack for a slow machine, where the loop takes longer.
    QVERIFY2(reports <= 20, qPrintable(QString::number(reports)));
}

DYNCAL_TEST(TestJobRunner)
#include "tst_job_runner.moc"
