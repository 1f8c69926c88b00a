// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/stages/frame/aligned_plots.h"

#include <QVBoxLayout>
#include <QtTest>

using namespace dyncal;

namespace {

PlotContent content(double largest)
{
    PlotContent content;
    content.xAxis = {"Time", "s"};
    content.yAxis = {"Value", ""};
    content.curves.push_back(
        {"curve", CurveRole::Measured, CurveStyle::Line, {0.0, 1.0}, {0.0, largest}, true});
    return content;
}

} // namespace

/// What lies above each other in plots of one axis belongs to one place of it.
class TestAlignedPlots : public QObject
{
    Q_OBJECT

private slots:
    void axes_beginAtOnePlace();
    void smallerLetters_giveTheRoomBack();

private:
    /// Numbers of one digit and of seven.
    struct Column : QWidget
    {
        Column()
        {
            auto *layout = new QVBoxLayout(this);
            for (PlotWidget *plot : {&one, &seven}) {
                layout->addWidget(plot);
                plots.add(plot);
            }
            one.setContent(content(1.0));
            seven.setContent(content(1.0000001e6));
            resize(500, 400);
            show();
        }
        bool isAligned() const
        {
            return one.axesRect().left() == seven.axesRect().left() && one.axesRect().left() > 20;
        }
        AlignedPlots plots;
        PlotWidget one, seven;
    };
};

void TestAlignedPlots::axes_beginAtOnePlace()
{
    PlotWidget alone;
    alone.setContent(content(1.0));
    alone.resize(500, 200);
    alone.show();
    QVERIFY(QTest::qWaitForWindowExposed(&alone));
    const Column column;
    QTRY_VERIFY(column.isAligned());
    QTRY_VERIFY(column.one.axesRect().left() > alone.axesRect().left()); // by the other's room
}

void TestAlignedPlots::smallerLetters_giveTheRoomBack()
{
    Column column;
    QTRY_VERIFY(column.isAligned());
    const int before = column.one.axesRect().left();
    QFont large = column.font();
    large.setPointSizeF(2.0 * large.pointSizeF());
    column.setFont(large);
    QTRY_VERIFY(column.isAligned() && column.one.axesRect().left() > before);
    large.setPointSizeF(0.5 * large.pointSizeF());
    column.setFont(large);
    QTRY_VERIFY(column.isAligned() && column.one.axesRect().left() <= before);
}

DYNCAL_TEST(TestAlignedPlots)
#include "tst_aligned_plots.moc"
