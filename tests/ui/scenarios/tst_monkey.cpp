// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/compact_heap.h"
#include "tests/support/allocated_memory.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/scenarios/monkey.h"
#include "tests/ui/scenarios/scenario_bench.h"

#include <QClipboard>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <malloc.h>
#include <mutex>
#include <numeric>
#include <thread>
#include <unistd.h>

using namespace dyncal;
using namespace dyncal::test;

namespace {

constexpr int kRound_ms = 10'000; ///< then everything is put back, and memory is read
constexpr int kRoundsCompared = 15; ///< in a row, for the growth of memory
constexpr double kMostGrowth = 0.05;
constexpr auto kDeadlock = std::chrono::seconds(60);

QStringList &warnings()
{
    static QStringList all;
    return all;
}

void noteWarnings(QtMsgType type, const QMessageLogContext &, const QString &text)
{
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    if (type == QtFatalMsg) // the program ends here
        std::fprintf(stderr, "%s\n", qPrintable(text));
    // Of the platform without a screen: it has no window manager to ask.
    const bool isOfPlatform = text.startsWith("This plugin does not support");
    if (type != QtDebugMsg && type != QtInfoMsg && !isOfPlatform && warnings().size() < 20)
        warnings() << text;
}

double resident_MiB()
{
    malloc_trim(0); // what was freed belongs to the system again
    QFile file("/proc/self/statm");
    if (!file.open(QIODevice::ReadOnly))
        return 0.0;
    const double pages = file.readAll().split(' ').value(1).toDouble();
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

/// What a page has drawn it keeps until it is shown again.
void showEveryPage(ScenarioBench &bench)
{
    for (int page = static_cast<int>(bench.window->pages().size()) - 1; page >= 0; --page) {
        bench.window->showPage(page);
        bench.settle();
        QTest::qWait(20);
    }
}

/// The pictures that plots keep of themselves, four of their size (curves, decorations, axes, what
/// lies above): far the most of what an empty window holds, and as large as the last acts left the
/// plots.
double pictures_MiB(const ScenarioBench &bench)
{
    constexpr double kBytesPerPixel = 4 * 4;
    double pixels = 0.0;
    for (const QWidget *plot : bench.window->findChildren<QWidget *>())
        if (plot->inherits("QCustomPlot"))
            pixels += plot->width() * plot->height() * std::pow(plot->devicePixelRatioF(), 2);
    return kBytesPerPixel * pixels / (1024.0 * 1024.0);
}

/// Ends the program with the act that it hangs in, where no act ends for a minute.
class DeadlockGuard
{
public:
    DeadlockGuard()
        : m_thread([this](const std::stop_token &stop) { watch(stop); })
    {
    }
    void pause()
    {
        const std::lock_guard lock(m_mutex);
        m_watches = false;
    }
    void beat(const QString &act)
    {
        const std::lock_guard lock(m_mutex);
        m_act = act;
        m_watches = true;
        m_last = std::chrono::steady_clock::now();
    }

private:
    void watch(const std::stop_token &stop)
    {
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            const std::lock_guard lock(m_mutex);
            if (m_watches && std::chrono::steady_clock::now() - m_last > kDeadlock) {
                std::fprintf(stderr, "hangs behind: %s\n", qPrintable(m_act));
                std::abort();
            }
        }
    }

    std::mutex m_mutex;
    QString m_act;
    bool m_watches = false;
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
    std::jthread m_thread;
};

} // namespace

/// Random acts for a minute in the suite, for ten minutes with three seeds in the long form:
/// no crash, no warning of Qt, no deadlock, no focus on what is not there, no growth.
class TestMonkey : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { keepHeapCompact(); } // as the window's program does
    void randomActs_breakNothing_data();
    void randomActs_breakNothing();
};

void TestMonkey::randomActs_breakNothing_data()
{
    QTest::addColumn<unsigned>("seed");
    for (const unsigned seed : {20261u, 20262u, 20263u})
        if (seed == 20261u || trials::count(0, 1) > 0)
            QTest::addRow("seed %u", seed) << seed;
}

void TestMonkey::randomActs_breakNothing()
{
    QFETCH(unsigned, seed);
    const int rounds = trials::count(6, 60);
    ScenarioBench bench;
    bench.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(bench.window.get()));
    Monkey monkey(bench, seed);
    DeadlockGuard guard;
    warnings().clear();
    const auto previous = qInstallMessageHandler(noteWarnings);
    std::vector<double> memory_MiB;
    QStringList faults, last;
    int acts = 0;
    for (int round = 0; round < rounds && faults.isEmpty(); ++round) {
        guard.pause(); // opening has a patience of its own
        while (QPointer<QWidget> menu = QApplication::activePopupWidget())
            menu->close(); // or its answer would act on what is opened next
        bench.prompts.dropAnswers(); // nor may one that was never asked for answer for it
        bench.window->session().reset({});
        // A plot's numbers there are up to 16 MiB, and the user's.
        QApplication::clipboard()->clear();
        bench.window->resize(1400, 900);
        showEveryPage(bench);
        // Of an empty window whose pages are all drawn empty: what was open differs by round.
        memory_MiB.push_back(resident_MiB() - pictures_MiB(bench));
        // Anew: where it was not open, a project may have been saved in its place, as was asked.
        QFile::remove(bench.folder.filePath("shots.h5"));
        bench.open({bench.record(threeShots())});
        if (rounds > 10)
            std::printf(
                "round %d: %d acts, %.1f MiB without %.1f MiB of pictures, %.1f MiB in use\n",
                round, acts, memory_MiB.back(), pictures_MiB(bench),
                testing::allocated_MiB() - pictures_MiB(bench));
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < kRound_ms && faults.isEmpty()) {
            last << monkey.act();
            guard.beat(last.last());
            if (last.size() > 12)
                last.removeFirst();
            QTest::qWait(1);
            ++acts;
            const QWidget *focused = QApplication::focusWidget();
            if (focused && bench.window->isAncestorOf(focused) && !focused->isWindow()
                && focused->window() == bench.window.get() && !focused->isVisible())
                faults << "The focus is on what is not shown: " + focused->objectName();
            if (!warnings().isEmpty())
                faults << warnings();
        }
    }
    qInstallMessageHandler(previous);
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n') + "\nbehind\n" + last.join('\n')));
    std::printf("seed %u: %d acts, resident at most %.0f MiB, %.0f MiB at the end\n", seed, acts,
        *std::ranges::max_element(memory_MiB), memory_MiB.back());
    if (rounds < 3 * kRoundsCompared)
        return; // caches fill for some minutes, and differ from round to round
    const auto end = memory_MiB.end();
    const double late = std::accumulate(end - kRoundsCompared, end, 0.0);
    const double early = std::accumulate(end - 3 * kRoundsCompared, end - 2 * kRoundsCompared, 0.0);
    QVERIFY2(late <= (1.0 + kMostGrowth) * early, qPrintable(QString("%1 %").arg(late / early)));
}

DYNCAL_TEST(TestMonkey)
#include "tst_monkey.moc"
