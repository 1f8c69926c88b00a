// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/job_runner.h"

#include <QThread>
#include <QtTest>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>

#include <dlfcn.h>
#include <pthread.h>

using namespace dyncal;

namespace {

std::atomic<bool> s_noThreads = false; ///< the system gives none
thread_local int t_failing = 0; ///< so many of this thread's allocations fail

} // namespace

extern "C" int pthread_create(
    pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *), void *argument)
{
    static auto *const real
        = reinterpret_cast<decltype(&::pthread_create)>(::dlsym(RTLD_NEXT, "pthread_create"));
    return s_noThreads ? EAGAIN : real(thread, attributes, start, argument);
}

void *operator new(std::size_t bytes)
{
    void *memory = t_failing > 0 ? nullptr : std::malloc(bytes > 0 ? bytes : 1);
    t_failing -= t_failing > 0 ? 1 : 0;
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

/// Qt uses it, too; what `operator delete` frees must come from the same place.
void *operator new(std::size_t bytes, const std::nothrow_t &) noexcept
{
    return std::malloc(bytes > 0 ? bytes : 1);
}

void operator delete(void *memory) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}

class TestJobRunner : public QObject
{
    Q_OBJECT

private slots:
    void result_whenDone_arrivesOnTheReceiversThread();
    void start_whileRunning_deliversOnlyTheNewest();
    void cancel_dropsTheResultAndAsksTheJobToStop();
    void exception_becomesInternalError();
    void lackOfMemory_becomesInternalError();
    void noMemoryForTheEnd_isSaidAllTheSame();
    void noThread_becomesInternalError();
    void noSecondThread_waitsForTheFirst();
    void manyJobs_allEndInTheirOrder();
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

/// What is to tell the receiver needs memory itself.
void TestJobRunner::noMemoryForTheEnd_isSaidAllTheSame()
{
    for (const int failing : {1, 2, 3, 5, 8}) {
        QObject receiver;
        JobRunner runner(&receiver);
        std::optional<Error> error;
        runner.start<int>(
            [failing](const JobControl &) -> Result<int> {
                t_failing = failing;
                return 1;
            },
            [&](Result<int> result) {
                if (!result)
                    error = result.error();
            });
        QTRY_VERIFY(error);
        QVERIFY(english(error->message).find("memory") != std::string::npos);
        QVERIFY(!runner.isRunning());
    }
}

void TestJobRunner::noThread_becomesInternalError()
{
    QObject receiver;
    JobRunner runner(&receiver);
    std::optional<Error> error;
    bool hasRun = false;
    const auto start = [&] {
        runner.start<int>(
            [&](const JobControl &) -> Result<int> {
                hasRun = true;
                return 1;
            },
            [&](Result<int> result) {
                error = result ? std::nullopt : std::optional(result.error());
            });
    };
    s_noThreads = true;
    start();
    s_noThreads = false;
    QTRY_VERIFY(error);
    QVERIFY(english(error->message).find("memory") != std::string::npos);
    QVERIFY(!hasRun && !runner.isRunning());
    start(); // there are threads again
    QTRY_VERIFY(!error);
    QVERIFY(hasRun);
}

/// The newer job is done, however late, and the older one's thread does it.
void TestJobRunner::noSecondThread_waitsForTheFirst()
{
    QObject receiver;
    JobRunner runner(&receiver, 2);
    std::atomic<bool> begun = false, mayEnd = false;
    runner.start<int>(
        [&](const JobControl &) -> Result<int> {
            begun = true;
            while (!mayEnd)
                QThread::msleep(1);
            return 1;
        },
        [](Result<int>) {});
    QTRY_VERIFY(begun);
    int value = 0;
    s_noThreads = true;
    runner.start<int>([](const JobControl &) -> Result<int> { return 2; },
        [&](Result<int> result) { value = *result; });
    s_noThreads = false;
    mayEnd = true;
    QTRY_COMPARE(value, 2);
}

/// Threads come and go between them.
void TestJobRunner::manyJobs_allEndInTheirOrder()
{
    QObject receiver;
    JobRunner runner(&receiver);
    int value = 0;
    for (int i = 1; i <= 300; ++i) {
        runner.start<int>([i](const JobControl &) -> Result<int> { return i; },
            [&value](Result<int> result) { value = value == *result - 1 ? *result : -1; });
        while (value == i - 1)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QCOMPARE(value, i);
    }
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
