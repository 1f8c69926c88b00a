// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/widget/overview_strip.h"
#include "ui/plot/widget/plot_widget.h"

#include <QVBoxLayout>
#include <QtTest>

#include <cmath>

using dyncal::CurveRole;
using dyncal::CurveStyle;
using dyncal::Interval;
using dyncal::OverviewStrip;
using dyncal::PlotContent;
using dyncal::PlotWidget;

namespace {

/// A ramp over [begin, end] seconds.
PlotContent ramp(double begin, double end)
{
    PlotContent content;
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Signal", "V"};
    dyncal::PlotCurve curve{"ramp", CurveRole::Measured, CurveStyle::Line, {}, {}, true};
    for (int i = 0; i <= 1000; ++i) {
        curve.x.push_back(begin + (end - begin) * i / 1000.0);
        curve.y.push_back(i);
    }
    content.curves.push_back(curve);
    return content;
}

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

} // namespace

class TestOverviewStrip : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void box_isThePartThatThePlotShows();
    void drag_ofTheBox_movesTheView();
    void drag_ofAnEdge_zooms();
    void press_besideTheBox_bringsItThere();
    void doubleClick_showsEverything();
    void plots_followEachOther();
    void content_refreshed_keepsTheView();
    void box_ofATinyView_canStillBeGrabbed();
    void strip_withoutData_ignoresTheMouse();
    void picture_showsTheCurve();

private:
    QPoint centre() const { return m_strip->box().center().toPoint(); }
    void drag(QPoint from, QPoint to)
    {
        QTest::mousePress(m_strip, Qt::LeftButton, {}, from);
        QTest::mouseMove(m_strip, to);
        QTest::mouseRelease(m_strip, Qt::LeftButton, {}, to);
    }
    /// What a pixel of the strip stands for; two of them are the tolerance of positions.
    double pixel() const
    {
        return m_strip->whole().length() / std::max(1, m_plot->axesRect().width());
    }

    std::unique_ptr<QWidget> m_window;
    PlotWidget *m_plot = nullptr;
    PlotWidget *m_other = nullptr;
    OverviewStrip *m_strip = nullptr;
};

void TestOverviewStrip::init()
{
    m_window = std::make_unique<QWidget>();
    auto *layout = new QVBoxLayout(m_window.get());
    m_strip = new OverviewStrip;
    m_plot = new PlotWidget;
    m_other = new PlotWidget;
    for (QWidget *widget : std::initializer_list<QWidget *>{m_strip, m_plot, m_other})
        layout->addWidget(widget);
    m_strip->follow(m_plot);
    m_strip->follow(m_other);
    m_plot->setContent(ramp(-1.0, 9.0));
    m_other->setContent(ramp(0.0, 2.0));
    m_window->resize(800, 600);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QTest::qWait(50);
}

void TestOverviewStrip::box_isThePartThatThePlotShows()
{
    QCOMPARE(m_strip->whole(), (Interval{-1.0, 9.0}));
    const double width = m_strip->box().width();
    QVERIFY(near(width, m_plot->axesRect().width(), 2.0));
    m_plot->setXRange({1.5, 4.0});
    QVERIFY(near(m_strip->box().width(), 0.25 * width, 1.0));
    m_plot->setXRange({-100.0, -50.0}); // beside the record: the box stays inside
    QVERIFY(m_strip->rect().contains(m_strip->box().toRect()));
}

void TestOverviewStrip::drag_ofTheBox_movesTheView()
{
    m_plot->setXRange({1.0, 3.0});
    const int way = m_plot->axesRect().width() / 5; // 2 s
    drag(centre(), centre() + QPoint(way, 0));
    QVERIFY(near(m_plot->xRange().begin, 3.0, 2.0 * pixel()));
    QVERIFY(near(m_plot->xRange().length(), 2.0, 1e-9));
}

void TestOverviewStrip::drag_ofAnEdge_zooms()
{
    m_plot->setXRange({1.0, 5.0});
    const QPoint right(static_cast<int>(m_strip->box().right()), centre().y());
    drag(right, right + QPoint(m_plot->axesRect().width() / 10, 0));
    QCOMPARE(m_plot->xRange().begin, 1.0);
    QVERIFY(near(m_plot->xRange().end, 6.0, 2.0 * pixel()));
    // Past the other edge it stops: the view never turns round.
    const QPoint left(static_cast<int>(m_strip->box().left()), centre().y());
    drag(left, QPoint(m_strip->width() - 1, left.y()));
    QVERIFY(m_plot->xRange().begin < m_plot->xRange().end);
}

void TestOverviewStrip::press_besideTheBox_bringsItThere()
{
    m_plot->setXRange({-1.0, 0.0});
    const QPoint there(m_strip->width() / 2, centre().y());
    drag(there, there);
    QVERIFY(near(m_strip->box().center().x(), there.x(), 2.0));
    QVERIFY(near(m_plot->xRange().length(), 1.0, 1e-9));
}

void TestOverviewStrip::doubleClick_showsEverything()
{
    m_plot->setXRange({1.0, 2.0});
    QTest::mouseDClick(m_strip, Qt::LeftButton, {}, centre());
    QCOMPARE(m_plot->xRange(), m_strip->whole());
}

void TestOverviewStrip::plots_followEachOther()
{
    QCOMPARE(m_other->xRange(), m_plot->xRange());
    m_other->setXRange({2.0, 3.0});
    QCOMPARE(m_plot->xRange(), (Interval{2.0, 3.0}));
    m_plot->setXRange({4.0, 5.0});
    QCOMPARE(m_other->xRange(), (Interval{4.0, 5.0}));
}

void TestOverviewStrip::content_refreshed_keepsTheView()
{
    m_plot->setXRange({2.0, 3.0});
    m_plot->setContent(ramp(-1.0, 9.0));
    m_other->setContent(ramp(0.0, 2.0));
    QCOMPARE(m_plot->xRange(), (Interval{2.0, 3.0}));
    QCOMPARE(m_other->xRange(), (Interval{2.0, 3.0}));
}

void TestOverviewStrip::box_ofATinyView_canStillBeGrabbed()
{
    m_plot->setXRange({4.0, 4.0 + 1e-6});
    QVERIFY(m_strip->box().width() >= 3.0);
    drag(centre(), centre() + QPoint(50, 0));
    QVERIFY(near(m_plot->xRange().length(), 1e-6, 1e-9));
    QVERIFY(near(m_plot->xRange().begin, 4.0 + 50.0 * pixel(), 2.0 * pixel()));
}

void TestOverviewStrip::strip_withoutData_ignoresTheMouse()
{
    OverviewStrip alone;
    alone.resize(300, 40);
    QTest::mousePress(&alone, Qt::LeftButton, {}, QPoint(100, 20));
    QTest::mouseMove(&alone, QPoint(150, 20));
    QTest::mouseDClick(&alone, Qt::LeftButton, {}, QPoint(100, 20));
    QVERIFY(!alone.grab().isNull());
    PlotWidget plot;
    alone.follow(&plot);
    const Interval before = plot.xRange();
    QTest::mouseDClick(&alone, Qt::LeftButton, {}, QPoint(100, 20));
    QCOMPARE(plot.xRange(), before);
}

void TestOverviewStrip::picture_showsTheCurve()
{
    // The ramp is low at the left and high at the right.
    const QImage image = m_strip->grab().toImage();
    const QRect axes = m_plot->axesRect();
    const auto colouredRow = [&](int x) {
        for (int y = 6; y < image.height() - 6; ++y)
            if (image.pixelColor(x, y).saturation() > 60)
                return y;
        return -1;
    };
    const int low = colouredRow(axes.left() + m_plot->x() - m_strip->x() + axes.width() / 4);
    const int high = colouredRow(axes.left() + m_plot->x() - m_strip->x() + axes.width() * 3 / 4);
    QVERIFY(low > 0 && high > 0);
    QVERIFY(low > high);
}

DYNCAL_TEST(TestOverviewStrip)
#include "tst_overview_strip.moc"
