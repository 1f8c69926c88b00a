// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/curves/pressure_curves.h"

#include <QTest>

using namespace dyncal;

namespace {

/// Pressures 1, 2, 3 ... with u = 0.5 and k = 2, from -1 ms on at 1 kHz.
ShotPressure shotOf(Index number, Index samples)
{
    ShotPressure shot;
    shot.shot = number;
    CorrectedPressure &pressure = shot.record.pressure;
    pressure.rate_Hz = 1e3;
    pressure.time_s = -1e-3;
    pressure.pressure_Pa = Eigen::VectorXd::LinSpaced(samples, 1.0, static_cast<double>(samples));
    pressure.u_Pa = Eigen::VectorXd::Constant(samples, 0.5);
    pressure.k = Eigen::VectorXd::Constant(samples, 2.0);
    return shot;
}

CorrectionOutcome outcomeOf(const std::vector<ShotPressure> &shots)
{
    CorrectionOutcome outcome;
    outcome.shots = shots;
    outcome.filter.lowPass.band_Hz = 150e3;
    return outcome;
}

CaptureSet capturesOf(std::size_t shots)
{
    CaptureSet set;
    set.shots.resize(shots);
    return set;
}

} // namespace

class TestPressureCurves : public QObject
{
    Q_OBJECT

private slots:
    void pressure_standsBetweenTheEndsOf95Percent()
    {
        const PlotContent content = pressureCurves(outcomeOf({shotOf(1, 4)}), capturesOf(1));
        QCOMPARE(content.curves.size(), std::size_t(3));
        QCOMPARE(content.curves[0].y, (std::vector<double>{2.0, 3.0, 4.0, 5.0}));
        QCOMPARE(content.curves[1].y, (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
        QCOMPARE(content.curves[2].y, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
        for (const PlotCurve &curve : content.curves) {
            QCOMPARE(curve.x.size(), std::size_t(4));
            QCOMPARE(curve.x.front(), -1e-3);
            QVERIFY(std::abs(curve.x.back() - 2e-3) < 1e-15);
        }
        QCOMPARE(content.xAxis.unit, QString("s"));
        QCOMPARE(content.yAxis.unit, QString("Pa"));
        QCOMPARE(content.curves[2].name, QString("Shot 1"));
        QVERIFY(content.curves[0].name.startsWith("Shot 1, upper"));
        QVERIFY(content.summary.contains("150 kHz"));
    }

    /// The number of a shot is that of the recordings: some of them may be left out.
    void shots_areNamedByTheirNumbers()
    {
        CaptureSet captures = capturesOf(3);
        captures.shots[2].level = ShotLevel::High;
        const CorrectionOutcome outcome = outcomeOf({shotOf(1, 4), shotOf(3, 10)});
        const PlotContent content = pressureCurves(outcome, captures);
        QCOMPARE(content.curves.size(), std::size_t(6));
        QVERIFY(content.curves[5].name.startsWith("Shot 3"));
        QVERIFY(content.curves[5].role == CurveRole::ShotHigh);
        QCOMPARE(pointsOf(outcome), Index(3 * 14));
    }

    void nothing_isAnEmptyPlot()
    {
        const PlotContent content = pressureCurves(outcomeOf({}), {});
        QVERIFY(content.curves.empty() && !content.title.isEmpty());
        QCOMPARE(pointsOf(outcomeOf({})), Index(0));
    }
};

DYNCAL_TEST(TestPressureCurves)
#include "tst_pressure_curves.moc"
