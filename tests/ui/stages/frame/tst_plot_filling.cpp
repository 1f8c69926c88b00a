// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/values/long_curves.h"
#include "ui/stages/frame/plot_filling.h"

#include <QSignalSpy>
#include <QThread>
#include <QtTest>

#include <atomic>
#include <stdexcept>

using namespace dyncal;

namespace {

constexpr Index kLong = kManyPoints + 1;

/// A straight line of `points` points under a title.
PlotContent line(const QString &title, Index points)
{
    PlotContent content;
    content.title = title;
    PlotCurve curve;
    curve.name = title;
    for (Index i = 0; i < points; ++i) {
        curve.x.push_back(static_cast<double>(i));
        curve.y.push_back(static_cast<double>(i));
    }
    content.curves.push_back(std::move(curve));
    return content;
}

/// Something that is made when the gate opens, and how often it was.
struct Gated
{
    std::shared_ptr<std::atomic<bool>> open = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<std::atomic<int>> made = std::make_shared<std::atomic<int>>(0);

    PlotMaking making(const std::shared_ptr<const void> &from, const QString &title) const
    {
        return {{from}, kLong, [gate = *this, title] {
                    while (!*gate.open)
                        QThread::msleep(1);
                    ++*gate.made;
                    return line(title, kLong);
                }};
    }
};

std::shared_ptr<const void> result()
{
    return std::make_shared<const int>(0);
}

} // namespace

class TestPlotFilling : public QObject
{
    Q_OBJECT

private slots:
    void shortCurves_areThereAtOnce();
    void longCurves_comeLaterAndTheOldOnesStay();
    void sameResults_areMadeOnce();
    void newResults_replaceThoseUnderWay();
    void shortCurvesOrNothing_endWhatWasUnderWay();
    void finish_isAppliedToWhatIsThere();
    void problem_isSaidOnThePlot();
    void plotThatGoes_takesItsJobAlong();
};

void TestPlotFilling::shortCurves_areThereAtOnce()
{
    PlotWidget plot;
    PlotFilling filling(&plot);
    filling.show({{result()}, 10, [] { return line("short", 10); },
        [](PlotContent content) {
            content.xMin = 3.0;
            return content;
        }});
    QCOMPARE(plot.content().title, QString("short"));
    QCOMPARE(plot.content().xMin, std::optional(3.0));
    QVERIFY(!filling.isBusy());
}

void TestPlotFilling::longCurves_comeLaterAndTheOldOnesStay()
{
    PlotWidget plot;
    PlotFilling filling(&plot);
    QSignalSpy changes(&filling, &PlotFilling::changed);
    filling.show({{result()}, 10, [] { return line("old", 10); }});
    const Gated gate;
    filling.show(gate.making(result(), "new"));
    QVERIFY(filling.isBusy());
    QCOMPARE(plot.content().title, QString("old"));
    *gate.open = true;
    QTRY_VERIFY(!filling.isBusy());
    QCOMPARE(plot.content().title, QString("new"));
    QVERIFY(plot.content().curves[0].record); // drawn at the cost of its pixels
    QCOMPARE(changes.count(), 2);
}

void TestPlotFilling::sameResults_areMadeOnce()
{
    PlotWidget plot;
    PlotFilling filling(&plot);
    const Gated gate;
    const auto from = result();
    for (int i = 0; i < 3; ++i)
        filling.show(gate.making(from, "same"));
    *gate.open = true;
    QTRY_VERIFY(!filling.isBusy());
    filling.show(gate.making(from, "same"));
    QVERIFY(!filling.isBusy());
    QCOMPARE(gate.made->load(), 1);
    QCOMPARE(plot.content().title, QString("same"));
}

void TestPlotFilling::newResults_replaceThoseUnderWay()
{
    PlotWidget plot;
    PlotFilling filling(&plot);
    const Gated gate;
    filling.show(gate.making(result(), "first"));
    filling.show(gate.making(result(), "second"));
    *gate.open = true;
    QTRY_VERIFY(!filling.isBusy());
    QCOMPARE(plot.content().title, QString("second"));
    QTest::qWait(20);
    QCOMPARE(plot.content().title, QString("second")); // the first never comes after it
}

void TestPlotFilling::shortCurvesOrNothing_endWhatWasUnderWay()
{
    for (const bool isNothing : {true, false}) {
        PlotWidget plot;
        PlotFilling filling(&plot);
        const Gated gate;
        filling.show(gate.making(result(), "long"));
        if (isNothing)
            filling.showAtOnce(line("now", 0));
        else
            filling.show({{result()}, 10, [] { return line("now", 10); }});
        QVERIFY(!filling.isBusy());
        *gate.open = true;
        QTest::qWait(50);
        QCOMPARE(plot.content().title, QString("now"));
    }
}

void TestPlotFilling::finish_isAppliedToWhatIsThere()
{
    PlotWidget plot;
    PlotFilling filling(&plot);
    const Gated gate;
    const auto from = result();
    const auto marked = [&](int marks) {
        PlotMaking making = gate.making(from, "marked");
        making.finish = [marks](PlotContent content) {
            for (int i = 0; i < marks; ++i)
                content.marks.push_back({1.0 * i, {}, CurveRole::Reference});
            return content;
        };
        return making;
    };
    filling.show(marked(1));
    filling.show(marked(2)); // while it is made
    *gate.open = true;
    QTRY_VERIFY(!filling.isBusy());
    QCOMPARE(plot.content().marks.size(), std::size_t{2});
    filling.show(marked(3)); // afterwards: the earlier ones are not there twice
    QCOMPARE(plot.content().marks.size(), std::size_t{3});
    QCOMPARE(gate.made->load(), 1);
}

void TestPlotFilling::problem_isSaidOnThePlot()
{
    PlotWidget plot;
    PlotFilling filling(&plot);
    const auto from = result();
    filling.show({{from}, kLong, []() -> PlotContent { throw std::runtime_error("broken"); }});
    QTRY_VERIFY(!filling.isBusy());
    QVERIFY(plot.content().curves.empty());
    QVERIFY(plot.content().title.contains("broken"));
    const Gated gate;
    *gate.open = true;
    filling.show(gate.making(from, "better")); // is tried again
    QTRY_VERIFY(!filling.isBusy());
    QCOMPARE(plot.content().title, QString("better"));
}

void TestPlotFilling::plotThatGoes_takesItsJobAlong()
{
    const Gated gate;
    auto plot = std::make_unique<PlotWidget>();
    auto *filling = new PlotFilling(plot.get());
    filling->show(gate.making(result(), "late"));
    *gate.open = true;
    plot.reset(); // waits for the job, which then has nowhere to go
    QTest::qWait(20);
}

DYNCAL_TEST(TestPlotFilling)
#include "tst_plot_filling.moc"
