// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/allowed_threads.h"
#include "core/base/parallel.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <mutex>
#include <set>
#include <thread>

using namespace dyncal;

namespace {

/// The threads that parts of a millisecond each are done on.
std::set<std::thread::id> threadsOfParts()
{
    std::mutex mutex;
    std::set<std::thread::id> threads;
    forEachPart(8, true, [&](Index) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        const std::scoped_lock lock(mutex);
        threads.insert(std::this_thread::get_id());
    });
    return threads;
}

} // namespace

/// The switch cannot be taken back, so one test has it all.
class TestAllowedThreads : public QObject
{
    Q_OBJECT

private slots:
    void oneThread_isTheCallersOwn();
};

void TestAllowedThreads::oneThread_isTheCallersOwn()
{
    QVERIFY(allowedThreads() >= 1);
    if (std::thread::hardware_concurrency() >= 2)
        QCOMPARE(threadsOfParts().size(), std::size_t(2));
    useOneThread();
    QCOMPARE(allowedThreads(), 1U);
    QCOMPARE(threadsOfParts(), std::set<std::thread::id>{std::this_thread::get_id()});
}

DYNCAL_TEST(TestAllowedThreads)
#include "tst_allowed_threads.moc"
