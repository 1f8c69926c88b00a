// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/stages/frame/stage_page.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

using namespace dyncal;

namespace {

constexpr int kPatience_ms = 600'000;
constexpr double kRate_Hz = 100e6;
constexpr qint64 kAim_ms = 100; ///< beside what is measured; docs/benchmarks.md has both
constexpr Index kStart = 2'000'000;
constexpr Index kPlateau = 100'000; ///< samples, then the tube's other waves
constexpr Index kRinging = 20'000;

/// A step with ringing, a plateau of 1 ms and a long rest, in counts of 0.1 mV with noise.
std::vector<std::int16_t> counts(Index samples, int shot)
{
    std::vector<std::int16_t> values(static_cast<std::size_t>(samples));
    std::uint32_t random = 12345U + static_cast<std::uint32_t>(shot);
    for (Index i = 0; i < samples; ++i) {
        random = random * 1664525U + 1013904223U;
        double value = static_cast<double>(random >> 28U) - 8.0;
        const Index behind = i - kStart;
        const double t_s = static_cast<double>(behind) / kRate_Hz;
        if (behind >= kPlateau)
            value += 4000.0;
        else if (behind >= 0)
            value += 8000.0;
        if (behind >= 0 && behind < kRinging)
            value -= 8000.0 * std::exp(-t_s / 1e-5) * std::cos(2e6 * t_s);
        values[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(value));
    }
    return values;
}

CaptureSet capture(Index samples, int shot)
{
    Channel channel;
    channel.name = "DUT";
    channel.role = ChannelRole::Dut;
    channel.sampleRate_Hz = kRate_Hz;
    channel.polynomial = {0.0, 1e-4};
    channel.samples = RawSamples(counts(samples, shot));
    CaptureSet set;
    Shot one;
    one.label = "shot " + std::to_string(shot);
    one.channels = {channel};
    set.shots = {one};
    return set;
}

} // namespace

/// The window answers while recordings of 100 million samples are read, computed and looked at.
class TestLongRecords : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void opened();
    void everyPage_shown();
    void records_zoomed();
    void window_changed();
    void longWindow_everyPage_shown();

private:
    Session &session() { return m_bench.window->session(); }
    /// Does something, waits until it is done, and tells how long the window gave no answer.
    void act(const QString &what, const std::function<void()> &deed);
    void settle();

    test::WindowBench m_bench{runPipeline};
    QStringList m_paths;
};

void TestLongRecords::initTestCase()
{
    const Index samples = trials::count(10'000'000, 100'000'000);
    for (int shot = 1; shot <= 3; ++shot) {
        m_paths << m_bench.folder.filePath(QString("shot_%1.h5").arg(shot));
        QVERIFY(writeHdf5Capture(capture(samples, shot), {m_paths.back().toStdString()},
            "2026-01-31T12:00:00Z", "A long shot."));
    }
    std::printf("long records: 3 x %.0f million samples\n", 1e-6 * static_cast<double>(samples));
    m_bench.window->resize(1366, 768);
    m_bench.window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_bench.window.get()));
}

void TestLongRecords::settle()
{
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench.window->files().isBusy() && !session().isComputing()
            && !session().envelopes().isBusy()
            && std::ranges::none_of(m_bench.window->pages(), &StagePage::isDrawing),
        kPatience_ms);
    QTest::qWait(200);
}

void TestLongRecords::act(const QString &what, const std::function<void()> &deed)
{
    test::EventLoopWatchdog watchdog;
    deed();
    settle();
    std::printf("%s: no answer for at most %lld ms, of which own work %lld ms (aim %lld ms)\n",
        qPrintable(what), watchdog.longestGap_ms(), watchdog.longestWork_ms(), kAim_ms);
    std::fflush(stdout);
}

void TestLongRecords::opened()
{
    act("opened and computed", [this] {
        m_bench.window->files().openPaths(m_paths);
        QTRY_VERIFY_WITH_TIMEOUT(session().state().hasShots(), kPatience_ms);
    });
    QVERIFY2(
        !session().error(), session().error() ? english(session().error()->message).c_str() : "");
}

void TestLongRecords::everyPage_shown()
{
    for (std::size_t row = 0; row < m_bench.window->pages().size(); ++row)
        act(QString("page %1 shown").arg(row + 1),
            [&] { m_bench.window->showPage(static_cast<int>(row)); });
}

void TestLongRecords::records_zoomed()
{
    m_bench.window->showPage(0);
    settle();
    auto *plot = m_bench.find<PlotWidget>("rawPlot_dut");
    const QPointF at = plot->axesRect().center();
    act("records zoomed in and out with the wheel", [&] {
        for (int turn = 0; turn < 40; ++turn) {
            QWheelEvent event(at, plot->mapToGlobal(at), {}, {0, turn < 20 ? 120 : -120},
                Qt::NoButton, {}, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(plot, &event);
            QTest::qWait(20);
        }
    });
}

void TestLongRecords::window_changed()
{
    act("window's end moved", [this] {
        Recipe recipe = session().recipe();
        recipe.window.end_s = 5e-3;
        session().apply(recipe, "end");
    });
}

/// A response of millions of samples.
void TestLongRecords::longWindow_everyPage_shown()
{
    constexpr double kLongWindow_s = 0.079;
    act("long window", [this] {
        Recipe recipe = session().recipe();
        recipe.window.end_s = kLongWindow_s;
        session().apply(recipe, "end");
    });
    QVERIFY(session().results().window->responses.front().window().size() > 7'000'000);
    everyPage_shown();
}

DYNCAL_TEST(TestLongRecords)
#include "tst_long_records.moc"
