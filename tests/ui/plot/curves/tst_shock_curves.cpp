// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_estimate.h"
#include "tests/support/test_program.h"
#include "ui/plot/curves/shock_curves.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

namespace {

constexpr double kAtWall_s = 2e-3;
constexpr double kRounding = 1e-12;

/// The thesis shot with a side sensor 0.8 m before the end wall.
ShockConditions thesisShot()
{
    CaptureSet set;
    Shot shot;
    shot.environment.p1_Pa = 101100.0;
    shot.environment.T1_K = 294.15;
    shot.environment.T4_K = 295.35;
    set.shots = {shot};
    set.tube
        = {{"driven_length_m", "0.97"}, {"driver_length_m", "0.97"}, {"inner_diameter_m", "0.1"}};
    ShockSettings settings;
    settings.arrivalSensors = {{"side", 0.8, 2e-4, kAtWall_s - 0.8 / 512.8, 1e-7, 0.0, 0.0}};
    return estimateShockConditions(set, {{1, kAtWall_s, 1e-9, true}}, settings).value().shots[0];
}

const PlotCurve *curve(const PlotContent &content, const char *name)
{
    const auto found = std::find_if(content.curves.begin(), content.curves.end(),
        [&](const PlotCurve &c) { return c.name == QLatin1String(name); });
    return found != content.curves.end() ? &*found : nullptr;
}

const PlotMark *mark(const PlotContent &content, const char *label)
{
    const auto found = std::find_if(content.marks.begin(), content.marks.end(),
        [&](const PlotMark &m) { return m.label == QLatin1String(label); });
    return found != content.marks.end() ? &*found : nullptr;
}

Channel sideChannel()
{
    Channel channel;
    channel.name = "side";
    channel.role = ChannelRole::DrivenSide;
    channel.unit = "V";
    channel.sampleRate_Hz = 1e6;
    channel.samples = RawSamples(RawSamples::Counts(std::vector<double>(4000, 0.25)));
    return channel;
}

} // namespace

class TestShockCurves : public QObject
{
    Q_OBJECT

private slots:
    void diagram_drawsTheShotsOwnNumbers()
    {
        const ShockConditions shot = thesisShot();
        const PlotContent content = tubeDiagramCurves(shot);
        const PlotCurve *shock = curve(content, "shock");
        QVERIFY(shock);
        const double slope_m_s
            = (shock->x.back() - shock->x.front()) / (shock->y.back() - shock->y.front());
        QVERIFY(std::abs(slope_m_s / shot.states->velocity_m_s - 1.0) < kRounding);
        QVERIFY(std::abs(shock->y.back() - kAtWall_s) < kRounding);
        const PlotCurve *reflected = curve(content, "reflected");
        QVERIFY(reflected && std::abs(reflected->y.front() - kAtWall_s) < kRounding);
        const PlotCurve *seen = curve(content, "seen");
        QVERIFY(seen && seen->x.size() == 2); // the side sensor and the DUT
        QVERIFY(std::abs(seen->x.front() - (0.97 - 0.8)) < kRounding);
        for (const char *name : {"side", "end wall", "diaphragm"})
            QVERIFY2(mark(content, name), name);
        QCOMPARE(mark(content, "end wall")->x, 0.97);
    }

    void diagram_plateauStandsAtTheEndWall()
    {
        const ShockConditions shot = thesisShot();
        const PlotContent content = tubeDiagramCurves(shot);
        const PlotCurve *plateau = curve(content, "plateau");
        QVERIFY(plateau);
        QCOMPARE(plateau->x.front(), 0.97);
        QVERIFY(std::abs(plateau->y.front() - kAtWall_s) < kRounding);
        QVERIFY(std::abs(plateau->y.back() - kAtWall_s - *shot.plateau_s) < kRounding);
    }

    void diagram_everyCurveRunsOneWay()
    {
        // Graphs sort their points by x.
        for (const PlotCurve &c : tubeDiagramCurves(thesisShot()).curves) {
            const bool up = std::is_sorted(c.x.begin(), c.x.end());
            const bool down = std::is_sorted(c.x.rbegin(), c.x.rend());
            QVERIFY2(up || down, qPrintable(c.name));
        }
    }

    void diagram_ofAnUnknownTube_isEmptyAndSaysWhy()
    {
        const PlotContent content = tubeDiagramCurves(ShockConditions());
        QVERIFY(content.curves.empty());
        QVERIFY(content.summary.contains("unknown"));
    }

    void arrival_showsLevelsAndTheDriverGas()
    {
        ShockConditions shot = thesisShot();
        SideArrival arrival;
        arrival.time_s = 0.44e-3;
        arrival.rise_s = 2e-6;
        arrival.before = 1.0;
        arrival.behind = 3.0;
        shot.seen = {{"side", arrival}};
        const PlotContent content = arrivalCurves(sideChannel(), shot, 0.8, {});
        QCOMPARE(content.levels.size(), std::size_t(3));
        QCOMPARE(content.levels[1].y, 2.0); // half way
        QVERIFY(*content.xMin<arrival.time_s && * content.xMax> arrival.time_s);
        QVERIFY(*content.yMin < 1.0 && *content.yMax > 3.0);
        const PlotMark *gas = mark(content, "driver gas (computed)");
        QVERIFY(gas);
        const double travelled_m
            = (gas->x - shot.diagram->burst_s) * shot.states->shocked.velocity_m_s;
        QVERIFY(std::abs(travelled_m - 0.17) < 1e-9); // as fast as the gas behind the shock
    }

    void arrivalAtTheDut_showsThePlateausEnd()
    {
        const ShockConditions shot = thesisShot();
        Channel dut = sideChannel();
        dut.name = "DUT";
        dut.role = ChannelRole::Dut;
        const PlotContent content = arrivalCurves(dut, shot, 0.0, {});
        QVERIFY(std::abs(mark(content, "plateau ends (computed)")->x - kAtWall_s - *shot.plateau_s)
            < kRounding);
        QVERIFY(std::abs(mark(content, "driver gas (computed)")->x - kAtWall_s
                    - shot.diagram->waves.driverGasFront_s)
            < kRounding);
    }

    void tubeModes_areTickedWhereTheSpectrumReaches()
    {
        const ShockConditions shot = thesisShot();
        PlotContent content;
        content.curves.push_back({"PSD", CurveRole::Measured, CurveStyle::Line, {0.0, 1000.0, 5e4},
            {0.0, 0.0, 0.0}, true});
        addTubeModes(content, shot);
        const PlotMark *first = mark(content, "(1,0)");
        QVERIFY(first);
        constexpr double kZero10 = 1.841184; // of J1'
        QVERIFY(std::abs(first->x - kZero10 * shot.states->reflected.soundSpeed_m_s / (M_PI * 0.1))
            < 0.01);
        QVERIFY(mark(content, "5.1")); // 1322 Hz for 1.94 m
        QVERIFY(!mark(content, "5.2")); // 89 Hz: below the first bin
        for (const PlotMark &m : content.marks)
            QVERIFY(m.x >= 1000.0);
        QVERIFY(content.title.contains("tube modes computed"));
    }

    void tubeModes_ofAShotWithout_changeNothing()
    {
        PlotContent content;
        content.title = "Spectrum";
        addTubeModes(content, ShockConditions());
        QVERIFY(content.marks.empty());
        QCOMPARE(content.title, QString("Spectrum"));
    }
};

DYNCAL_TEST(TestShockCurves)
#include "tst_shock_curves.moc"
