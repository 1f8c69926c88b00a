// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/window/window_page.h"

#include <QMenu>
#include <QTimer>

using namespace dyncal;
using test::PageBench;

/// What pages give their plots: cursors in common, a place that is typed, values in a table.
class TestPlotTools : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void timeCursors_areSharedByThePlotsOfAResponse();
    void goTo_typedWithAUnit();
    void goTo_whatCannotBeTaken_isSaid();
    void goTo_onAPageThatWasLeft_opensNothing();
    void table_showsAllShots_andFollowsTheCursors();
    void table_goesWithItsPage();
    void menu_offersWhatThePageHas();
    void menu_mayOutliveItsPlot();

private:
    static PlotWidget *plot(PageBench<WindowPage> &bench, const char *name)
    {
        auto *found = bench.control<PlotWidget>(name);
        found->setFocus();
        return found;
    }
    static QLineEdit *goToField(PlotWidget *plot)
    {
        QTest::keyClick(plot, Qt::Key_G, Qt::ControlModifier);
        return plot->findChild<QLineEdit *>("goToField");
    }
};

void TestPlotTools::timeCursors_areSharedByThePlotsOfAResponse()
{
    PageBench<WindowPage> bench;
    PlotWidget *whole = plot(bench, "windowPlot");
    const PlotWidget *detail = plot(bench, "windowDetailPlot");
    whole->goTo(2e-6);
    QCOMPARE(detail->cursorValues().x[0], whole->cursorValues().x[0]);
    QVERIFY(detail->cursorValues().x[0].has_value());
    QVERIFY(!bench.session.cursors(CursorAxis::Frequency).positions()[0]);
    QVERIFY(!bench.session.cursors(CursorAxis::RecordTime).positions()[0]);
    QTest::keyClick(whole, Qt::Key_Escape);
    QVERIFY(!detail->cursorValues().x[0]);
}

void TestPlotTools::goTo_typedWithAUnit()
{
    PageBench<WindowPage> bench;
    PlotWidget *whole = plot(bench, "windowPlot");
    QLineEdit *field = goToField(whole);
    QVERIFY(field && field->isVisible());
    QTest::keyClicks(field, "3.02 us");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(std::abs(whole->cursorValues().x[0].value_or(0.0) - 3e-6) < 0.6 / test::kRate_Hz);
    QTRY_VERIFY(!whole->findChild<QLineEdit *>("goToField"));
    field = goToField(whole);
    QTest::keyClicks(field, "5");
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_VERIFY(!whole->findChild<QLineEdit *>("goToField"));
    QVERIFY(std::abs(*whole->cursorValues().x[0] - 3e-6) < 0.6 / test::kRate_Hz);
}

void TestPlotTools::goTo_whatCannotBeTaken_isSaid()
{
    PageBench<WindowPage> bench;
    PlotWidget *whole = plot(bench, "windowPlot");
    const Interval view = whole->xRange();
    QLineEdit *field = goToField(whole);
    QTest::keyClicks(field, "soon");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(!refusalOnShow(field).isEmpty());
    field->clear();
    QTest::keyClicks(field, "20 s");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY2(refusalOnShow(field).contains("20.00"), qPrintable(refusalOnShow(field)));
    QCOMPARE(whole->xRange(), view);
    QVERIFY(!whole->cursorValues().x[0]);
}

void TestPlotTools::goTo_onAPageThatWasLeft_opensNothing()
{
    PageBench<WindowPage> bench;
    PlotWidget *whole = plot(bench, "windowPlot");
    bench.page.hide();
    emit whole->goToRequested();
    QVERIFY(!whole->findChild<QLineEdit *>("goToField"));
}

void TestPlotTools::table_showsAllShots_andFollowsTheCursors()
{
    PageBench<WindowPage> bench;
    PlotWidget *whole = plot(bench, "windowPlot");
    emit whole->cursorTableRequested();
    const auto *table = bench.page.findChild<ValueTable *>("cursorTable");
    QVERIFY(table && table->isVisible());
    QCOMPARE(table->rowCount(), 4); // time and three shots
    QCOMPARE(table->item(1, 1)->text(), QString::fromUtf8("–"));
    whole->goTo(2e-6);
    QVERIFY(table->item(0, 1)->text().contains("s"));
    for (int shot = 0; shot < 3; ++shot) {
        const QString text = table->item(shot + 1, 1)->text();
        QVERIFY(!text.contains(QChar(0x2013)));
        QVERIFY(std::abs(text.section(' ', 0, 0).toDouble()) > 0.0);
    }
    QTest::keyClick(whole, Qt::Key_Escape);
    QCOMPARE(table->item(1, 1)->text(), QString::fromUtf8("–"));
}

void TestPlotTools::table_goesWithItsPage()
{
    PageBench<WindowPage> bench;
    emit plot(bench, "windowPlot")->cursorTableRequested();
    auto *window = bench.page.findChild<QWidget *>("cursorTableWindow");
    QVERIFY(window && window->isVisible());
    bench.page.hide();
    QVERIFY(!window->isVisible());
    bench.page.show();
    QVERIFY(window->isVisible());
    window->close();
    bench.page.hide();
    bench.page.show();
    QVERIFY(!window->isVisible());
}

void TestPlotTools::menu_offersWhatThePageHas()
{
    PageBench<WindowPage> bench;
    PlotWidget *whole = plot(bench, "windowPlot");
    const auto offeredBy = [](PlotWidget &plot) {
        QContextMenuEvent asked(QContextMenuEvent::Keyboard, QPoint(5, 5), QPoint(5, 5));
        QApplication::sendEvent(&plot, &asked);
        QStringList offered;
        auto *menu = plot.findChild<QMenu *>("plotMenu");
        for (const QAction *action : menu->actions())
            offered << action->text();
        menu->close();
        return offered;
    };
    QStringList offered = offeredBy(*whole);
    QVERIFY(offered.contains("Export..."));
    QVERIFY(offered.contains("Go to..."));
    QVERIFY(offered.contains("Values at the cursors"));
    PlotWidget alone;
    offered = offeredBy(alone);
    QVERIFY(offered.contains("Copy data"));
    QVERIFY(!offered.contains("Export..."));
}

/// As when the language is changed while it is open.
void TestPlotTools::menu_mayOutliveItsPlot()
{
    auto plot = std::make_unique<PlotWidget>();
    plot->show();
    QContextMenuEvent asked(QContextMenuEvent::Keyboard, QPoint(5, 5), QPoint(5, 5));
    QApplication::sendEvent(plot.get(), &asked);
    QVERIFY(plot->findChild<QMenu *>("plotMenu"));
    plot.reset();
    QApplication::processEvents();
    QVERIFY(!QApplication::activePopupWidget());
}

DYNCAL_TEST(TestPlotTools)
#include "tst_plot_tools.moc"
