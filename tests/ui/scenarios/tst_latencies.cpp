// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_bench.h"

#include <cstdio>

using namespace dyncal;
using namespace dyncal::test;

namespace {

constexpr int kMoves = 40;
/// A machine that tests does other work as well: the targets are printed beside what was measured,
/// and only what an operator would call stuck is a failure.
constexpr double kStuck_ms = 1000.0;

double percentile(std::vector<double> values, double share)
{
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// True unless the window was stuck.
bool report(const char *what, const std::vector<double> &latency_ms, double target_ms)
{
    std::printf("%s: p50 %.1f ms, p95 %.1f ms, longest %.1f ms (target p95 %.0f ms)\n", what,
        percentile(latency_ms, 0.5), percentile(latency_ms, 0.95), percentile(latency_ms, 1.0),
        target_ms);
    std::fflush(stdout);
    return percentile(latency_ms, 0.95) < kStuck_ms;
}

/// From an act to the last drawing that follows it at once.
double untilDrawn_ms(PlotWidget *plot, const std::function<void()> &act)
{
    bool drawn = false;
    const auto watch = QObject::connect(plot, &PlotWidget::replotted, [&] { drawn = true; });
    QElapsedTimer clock;
    clock.start();
    act();
    while (!drawn && clock.elapsed() < kPatience_ms)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    const double took_ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    QObject::disconnect(watch);
    return took_ms;
}

} // namespace

/// How long the operator waits, act by act. The drag of the order is in tests/ui/latency.
class TestLatencies : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void s17_windowEnd_dragged();
    void wheel_zoomsTheRecords();
    void undoAndRedo_ofAnOrder();
    void pages_areShown();

private:
    std::unique_ptr<ScenarioBench> m_bench;
};

void TestLatencies::initTestCase()
{
    m_bench = std::make_unique<ScenarioBench>();
    m_bench->open({m_bench->record(threeShots())});
}

void TestLatencies::s17_windowEnd_dragged()
{
    m_bench->show(Page::Window);
    m_bench->settle();
    auto *plot = m_bench->find<PlotWidget>("windowPlot");
    const double y = 0.5 * (plot->yRange().begin + plot->yRange().end);
    const auto &handles = plot->handles();
    const double from_s = std::ranges::find(handles, QString("end"), &HandleState::id)->x.begin;
    const double step_s = 0.1 * from_s / kMoves;
    QTest::mousePress(plot, Qt::LeftButton, {}, plot->pixelOf(from_s, y));
    std::vector<double> latency_ms;
    for (int move = 1; move <= kMoves; ++move)
        latency_ms.push_back(untilDrawn_ms(plot, [&] {
            QTest::mouseMove(plot, plot->pixelOf(from_s - move * step_s, y) - QPoint(2, 0));
        }));
    m_bench->release(plot, 0.9 * from_s);
    QVERIFY(report("window's end dragged, to the pixels", latency_ms, 33.0));
    m_bench->undo();
}

void TestLatencies::wheel_zoomsTheRecords()
{
    m_bench->show(Page::Captures);
    m_bench->settle();
    auto *plot = m_bench->find<PlotWidget>("rawPlot_dut");
    const QPointF at = plot->axesRect().center();
    std::vector<double> latency_ms;
    for (int turn = 0; turn < kMoves; ++turn) {
        const int angle = turn < kMoves / 2 ? 120 : -120;
        latency_ms.push_back(untilDrawn_ms(plot, [&] {
            QWheelEvent event(at, plot->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, {},
                Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(plot, &event);
        }));
    }
    QVERIFY(report("records zoomed with the wheel", latency_ms, 33.0));
}

void TestLatencies::undoAndRedo_ofAnOrder()
{
    m_bench->show(Page::Order);
    m_bench->settle();
    auto *plot = m_bench->find<PlotWidget>("orderFitPlot");
    QTest::keyClick(m_bench->find<PlotWidget>("singularValuePlot"), Qt::Key_Right);
    m_bench->settle();
    std::vector<double> latency_ms;
    for (int turn = 0; turn < kMoves / 4; ++turn)
        for (const auto key : {QKeySequence::Undo, QKeySequence::Redo}) {
            latency_ms.push_back(untilDrawn_ms(
                plot, [&] { QTest::keySequence(m_bench->window.get(), QKeySequence(key)); }));
            m_bench->settle();
        }
    QVERIFY(report("undo and redo of an order", latency_ms, 100.0));
}

void TestLatencies::pages_areShown()
{
    std::vector<double> latency_ms;
    for (int turn = 0; turn < 3; ++turn)
        for (int page = 0; page < kPageCount; ++page) {
            QElapsedTimer clock;
            clock.start();
            m_bench->window->showPage(page);
            QCoreApplication::processEvents();
            latency_ms.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
        }
    QVERIFY(report("another page shown", latency_ms, 100.0));
}

DYNCAL_TEST(TestLatencies)
#include "tst_latencies.moc"
