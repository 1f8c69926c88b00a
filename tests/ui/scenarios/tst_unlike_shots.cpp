// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"

using namespace dyncal;
using namespace dyncal::test;

/// Good shots that were not recorded alike.
class TestUnlikeShots : public QObject
{
    Q_OBJECT

private slots:
    void s11_oneShotAtHalfTheRate_givesTheSameSensor();
    void s12_oneShorterShot_limitsTheWindow();
};

void TestUnlikeShots::s11_oneShotAtHalfTheRate_givesTheSameSensor()
{
    const ScenarioBench alike;
    alike.open({alike.record(threeShots())});
    const ScenarioBench unlike;
    unlike.open({unlike.record(threeShots({{DefectKind::Fs50, 3}}))});
    QVERIFY(alike.finding("CAP-004").isEmpty());
    DYNCAL_SAYS(unlike.finding("CAP-004"), "20 MHz, 20 MHz, 10 MHz");
    DYNCAL_SAYS(unlike.finding("CAP-004"), "brought to 10 MHz");
    const auto poles = [](const ScenarioBench &bench) {
        bench.show(Page::Model);
        return bench.row("poleTable", "2.33");
    };
    const QStringList expected = poles(alike);
    const QStringList found = poles(unlike);
    for (const auto &[column, tolerance] : {std::pair{0, 0.001}, std::pair{3, 0.02}}) {
        const double one = number(expected.value(column));
        QVERIFY2(std::abs(number(found.value(column)) / one - 1.0) < tolerance,
            qPrintable(expected.join('|') + "; " + found.join('|')));
    }
    DYNCAL_SAYS(certificateText(unlike), "Shots have different sample rates");
}

void TestUnlikeShots::s12_oneShorterShot_limitsTheWindow()
{
    const ScenarioBench bench;
    bench.open({bench.record(threeShots({{DefectKind::Short, 2}}))});
    DYNCAL_SAYS(bench.finding("CAP-005"), "different lengths");
    bench.show(Page::Window);
    bench.type("windowEndValue", "380 µs");
    QVERIFY(!bench.session().error());
    auto *plot = bench.find<PlotWidget>("windowPlot");
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_F);
    QTest::keyClick(plot, Qt::Key_Minus);
    QTest::qWait(50);
    bench.dragLine(plot, "end", 0.45e-3);
    bench.release(plot, 0.45e-3);
    QVERIFY2(!bench.session().error(), qPrintable(bench.findings().join('\n')));
    const auto &handles = plot->handles();
    const auto end = std::ranges::find(handles, QString("end"), &HandleState::id);
    QVERIFY2(end->x.begin > 0.399e-3 && end->x.begin <= 0.4005e-3,
        qPrintable(QString::number(end->x.begin)));
    DYNCAL_SAYS(bench.text("windowEndCommon"), "The record of shot 2 ends here");
}

DYNCAL_TEST(TestUnlikeShots)
#include "tst_unlike_shots.moc"
