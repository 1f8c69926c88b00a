// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/quick_pipeline.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/stages/frame/stage_page.h"

#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include <map>

using namespace dyncal;

namespace {

constexpr double kDuration_s = 0.006;
constexpr int kPatience_ms = 120'000;
constexpr int kSteps = 4; ///< of the mouse on its way to the edge

/// A plot of the window as it was before a drag.
struct Seen
{
    bool hasCurves = false;
    QString xUnit;
    QString yUnit;
};

} // namespace

/// Every handle of every plot is dragged to both edges of its plot, on the example taken as a step
/// and as a free decay.
class TestHandles : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void everyHandle_toBothEdges_blanksNothing_data();
    void everyHandle_toBothEdges_blanksNothing();
    void escape_givesTheSameRecipe_data();
    void escape_givesTheSameRecipe();

private:
    Session &session() { return m_bench->window->session(); }
    void waitComputed()
    {
        QTRY_VERIFY_WITH_TIMEOUT(
            !session().isComputing() && (session().isUpToDate() || session().error()),
            kPatience_ms);
    }
    void setTreatment(ResponseTreatment treatment);
    void showPage(std::size_t row);
    std::map<PlotWidget *, Seen> everyPage();
    void compare(const std::map<PlotWidget *, Seen> &before, const QString &after);
    /// Calls `drag` with each page's row, each visible plot and each grip of its handles.
    void forEveryGrip(const std::function<void(int, PlotWidget *, QPoint)> &drag);
    static void dragTo(PlotWidget *plot, QPoint from, int x);

    std::unique_ptr<test::WindowBench> m_bench;
};

void TestHandles::initTestCase()
{
    m_bench = std::make_unique<test::WindowBench>(test::quickPipeline());
    m_bench->window->resize(1400, 900);
    m_bench->window->show();
    m_bench->window->files().setExampleDuration(kDuration_s);
    m_bench->window->files().openExample();
    QTRY_VERIFY_WITH_TIMEOUT(session().state().hasShots(), kPatience_ms);
    waitComputed();
}

void TestHandles::setTreatment(ResponseTreatment treatment)
{
    Recipe recipe = session().recipe();
    recipe.input.treatment = treatment;
    session().apply(recipe, "Treatment");
    waitComputed();
    QVERIFY(!session().error());
}

/// Until its curves are those of the results: long ones come a moment later.
void TestHandles::showPage(std::size_t row)
{
    m_bench->window->showPage(static_cast<int>(row));
    const StagePage &page = *m_bench->window->pages()[row];
    QTRY_VERIFY_WITH_TIMEOUT(!page.isDrawing(), kPatience_ms);
}

std::map<PlotWidget *, Seen> TestHandles::everyPage()
{
    std::map<PlotWidget *, Seen> seen;
    const auto &pages = m_bench->window->pages();
    for (std::size_t row = 0; row < pages.size(); ++row) {
        showPage(row);
        for (PlotWidget *plot : pages[row]->findChildren<PlotWidget *>()) {
            const PlotContent &content = plot->content();
            seen[plot] = {!content.curves.empty() && plot->isVisible(), content.xAxis.unit,
                content.yAxis.unit};
        }
    }
    return seen;
}

void TestHandles::compare(const std::map<PlotWidget *, Seen> &before, const QString &after)
{
    for (const auto &[plot, now] : everyPage()) {
        const Seen &then = before.at(plot);
        if (!then.hasCurves || QTest::currentTestFailed())
            continue;
        const QString where = plot->objectName() + " after " + after;
        QVERIFY2(now.hasCurves,
            qPrintable(where + " is blank: "
                + (session().error() ? QString::fromStdString(english(session().error()->message))
                                     : QString("no error"))));
        QCOMPARE(now.xUnit, then.xUnit);
        QCOMPARE(now.yUnit, then.yUnit);
    }
}

void TestHandles::forEveryGrip(const std::function<void(int, PlotWidget *, QPoint)> &drag)
{
    const auto &pages = m_bench->window->pages();
    int grips = 0;
    for (std::size_t row = 0; row < pages.size(); ++row) {
        showPage(row);
        for (PlotWidget *plot : pages[row]->findChildren<PlotWidget *>()) {
            const std::vector<HandleState> handles
                = plot->isVisible() ? plot->handles() : std::vector<HandleState>();
            for (const HandleState &handle : handles) {
                if (!handle.movable || QTest::currentTestFailed())
                    continue;
                for (const double x : handle.isLine
                        ? std::vector<double>{handle.x.begin}
                        : std::vector<double>{handle.x.begin, handle.x.end}) {
                    const double y = 0.5 * (plot->yRange().begin + plot->yRange().end);
                    const double drawn = handle.snapToIntegers ? x + 0.5 : x;
                    drag(static_cast<int>(row), plot, plot->pixelOf(drawn, y));
                    ++grips;
                }
            }
        }
    }
    qInfo("%d grips", grips);
    QVERIFY(grips >= 6);
}

/// Presses at `from` and moves to the pixel column `x`; the button stays down.
void TestHandles::dragTo(PlotWidget *plot, QPoint from, int x)
{
    for (int step = 1; step <= kSteps; ++step) {
        const QPoint at(from.x() + (x - from.x()) * step / kSteps, from.y());
        QTest::mouseMove(plot, at);
        QTest::qWait(20);
    }
}

void TestHandles::everyHandle_toBothEdges_blanksNothing_data()
{
    QTest::addColumn<int>("treatment");
    QTest::newRow("step") << static_cast<int>(ResponseTreatment::StepDeflated);
    QTest::newRow("free decay") << static_cast<int>(ResponseTreatment::Impulse);
}

void TestHandles::everyHandle_toBothEdges_blanksNothing()
{
    QFETCH(int, treatment);
    setTreatment(static_cast<ResponseTreatment>(treatment));
    const auto before = everyPage();
    const Recipe recipe = session().recipe();
    int grips = 0;
    forEveryGrip([&](int row, PlotWidget *plot, QPoint grip) {
        // In the suite each grip goes to one edge, in turns.
        const bool isFirst = ++grips % 2 == 0;
        for (const bool toTheRight : {false, true}) {
            if (trials::count(1, 2) == 1 && toTheRight != isFirst)
                continue;
            m_bench->window->showPage(row);
            const QRect axes = plot->axesRect();
            const int x = toTheRight ? axes.right() - 1 : axes.left() + 1;
            QTest::mousePress(plot, Qt::LeftButton, {}, grip);
            dragTo(plot, grip, x);
            waitComputed();
            QVERIFY2(!plot->content().curves.empty(), qPrintable(plot->objectName()));
            QTest::mouseRelease(plot, Qt::LeftButton, {}, {x, grip.y()});
            waitComputed();
            compare(
                before, QString("%1 px to %2").arg(grip.x()).arg(x) + " of " + plot->objectName());
            while (!(session().recipe() == recipe) && session().undoStack().canUndo())
                session().undoStack().undo();
            waitComputed();
            QVERIFY(session().recipe() == recipe);
        }
    });
}

void TestHandles::escape_givesTheSameRecipe_data()
{
    everyHandle_toBothEdges_blanksNothing_data();
}

void TestHandles::escape_givesTheSameRecipe()
{
    QFETCH(int, treatment);
    setTreatment(static_cast<ResponseTreatment>(treatment));
    const Recipe recipe = session().recipe();
    const int steps = session().undoStack().count();
    forEveryGrip([&](int row, PlotWidget *plot, QPoint grip) {
        m_bench->window->showPage(row);
        const QRect axes = plot->axesRect();
        QTest::mousePress(plot, Qt::LeftButton, {}, grip);
        dragTo(plot, grip, axes.left() + 1);
        dragTo(plot, {axes.left() + 1, grip.y()}, axes.right() - 1);
        QTest::keyClick(plot, Qt::Key_Escape);
        QTest::mouseRelease(plot, Qt::LeftButton, {}, {axes.right() - 1, grip.y()});
        QVERIFY2(session().recipe() == recipe, qPrintable(plot->objectName()));
        QCOMPARE(session().undoStack().count(), steps);
        waitComputed();
    });
}

DYNCAL_TEST(TestHandles)
#include "tst_handles.moc"
