// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/response_window.h"
#include "core/signal/window_bands.h"
#include "core/signal/window_checks.h"
#include "tests/core/signal/window_records.h"
#include "tests/support/test_program.h"

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

class TestResponseWindow : public QObject
{
    Q_OBJECT

private slots:
    void step_allAutomatic_measuresKnownLevels();
    void step_values_reproduceTheRecord();
    void step_withoutRemap_keepsTheUnit();
    void step_quietRecord_hasNoFindings();
    void baseline_automatic_endsAGuardBeforeTheStart_data();
    void baseline_automatic_endsAGuardBeforeTheStart();
    void baseline_null_subtractsNothing();
    void baseline_behindTheResponse_isUsed();
    void baseline_wrongPlace_isBlocked();
    void end_plateauThatFalls_isNinetyPercent_data();
    void end_plateauThatFalls_isNinetyPercent();
    void end_slowRinging_isNotADeparture_data();
    void end_slowRinging_isNotADeparture();
    void end_decay_isWhereNoiseBegins();
    void end_lateBaseline_limitsTheWindow();
    void end_typedBeyondRecord_namesTheLargest();
    void end_ofEachShot_isItsOwn();
    void end_plateau_isTakenFromShockData();
    void settle_typed_mustLieInside();
    void start_typed_oneOrPerShot();
    void start_typedOutside_isBlocked();
};

void TestResponseWindow::step_allAutomatic_measuresKnownLevels()
{
    const auto result = cut(stepChannel());
    const WindowedResponse &r = only(result);
    QCOMPARE(r.shot, Index(1));
    QCOMPARE(r.label, std::string("shot 1"));
    QCOMPARE(r.channel, std::string("DUT"));
    QCOMPARE(r.unit, std::string("V"));
    QCOMPARE(r.sampleRate_Hz, 10e6);
    QVERIFY(r.startDetected);
    QVERIFY(r.startSample >= 4000 && r.startSample <= 4003);
    QCOMPARE(r.start_s, -4e-4 + static_cast<double>(r.startSample) / 10e6);

    const double sd = 0.0025;
    QVERIFY(std::abs(r.baseline - 0.2) < 5.0 * sd / std::sqrt(3800.0));
    QVERIFY(std::abs(r.settled - 2.7) < 5.0 * sd / std::sqrt(12000.0));
    QCOMPARE(r.step, r.settled - r.baseline);
    QVERIFY(std::abs(r.noiseSd / sd - 1.0) < 0.06); // 3800 samples: sd 1.1 %
    QVERIFY(std::abs(r.snr_dB - 60.0) < 0.6);
    QCOMPARE(r.valueScale, r.step);

    // record end: 36 000 samples behind the start
    QCOMPARE(r.length, Index(40000) - r.startSample);
    QCOMPARE(r.end_s, static_cast<double>(r.length) / 10e6);
    QVERIFY(std::abs(r.settle_s.begin - 0.6 * r.end_s) < 2e-7);
    QVERIFY(std::abs(r.settle_s.end - 0.95 * r.end_s) < 2e-7);
    // closed form for zeta 0.1: overshoot 72.92476 %, rise 0.175739/f0, settling 4.610377/f0
    QVERIFY(std::abs(*r.overshoot_percent - 72.925) < 0.8);
    QVERIFY(std::abs(*r.riseTime_s * 300e3 - 0.1757) < 0.003);
    QVERIFY(std::abs(*r.settlingTime_s * 300e3 - 4.61) < 0.1);
}

void TestResponseWindow::step_values_reproduceTheRecord()
{
    const Channel channel = stepChannel();
    const auto result = cut(channel);
    const WindowedResponse &r = only(result);
    QVERIFY(r.lead <= r.startSample && r.lead + r.length <= r.values.size());
    const Eigen::VectorXd record = physicalValues(channel, r.startSample - r.lead, r.values.size());
    const Eigen::VectorXd back = (r.baseline + r.valueScale * r.values.array()).matrix();
    QVERIFY((back - record).cwiseAbs().maxCoeff() < 1e-14);
    QVERIFY(static_cast<double>(r.lead) / 10e6 >= -r.baseline_s.begin - 1e-12);
    QVERIFY(r.window().size() == r.length && r.window()[0] == r.values[r.lead]);

    const auto baseline = static_cast<Index>(std::llround(r.baseline_s.length() * 10e6));
    QCOMPARE(r.noise.size(), baseline);
    QVERIFY(std::abs(r.noise.mean()) < 1e-12);
    const double sd = std::sqrt(r.noise.squaredNorm() / static_cast<double>(baseline - 2));
    QVERIFY(std::abs(sd * r.step / r.noiseSd - 1.0) < 1e-12);
}

void TestResponseWindow::step_withoutRemap_keepsTheUnit()
{
    WindowContext context;
    context.remap = false;
    const auto plain = cut(stepChannel(), {}, context), remapped = cut(stepChannel());
    QCOMPARE(only(plain).valueScale, 1.0);
    const Eigen::VectorXd difference
        = only(plain).values - only(remapped).values * only(remapped).step;
    QVERIFY(difference.cwiseAbs().maxCoeff() < 1e-14);
    QCOMPARE(*only(plain).overshoot_percent, *only(remapped).overshoot_percent);
}

void TestResponseWindow::step_quietRecord_hasNoFindings()
{
    for (const double noise : {0.0, 0.001, 0.02}) {
        const auto result = cut(stepChannel(noise));
        QVERIFY(result.has_value());
        for (const Finding &finding : result->findings)
            QFAIL(english(finding.message).c_str());
    }
}

void TestResponseWindow::baseline_automatic_endsAGuardBeforeTheStart_data()
{
    QTest::addColumn<int>("start");
    QTest::addColumn<int>("begin");
    QTest::addColumn<int>("end");
    QTest::newRow("least guard") << 60 << 0 << 55;
    QTest::newRow("a twentieth") << 400 << 0 << 380;
    QTest::newRow("longest baseline") << 30000 << 9000 << 29000;
    QTest::newRow("too short") << 54 << -1 << -1;
    QTest::newRow("none") << 0 << -1 << -1;
}

void TestResponseWindow::baseline_automatic_endsAGuardBeforeTheStart()
{
    QFETCH(int, start);
    QFETCH(int, begin);
    QFETCH(int, end);
    const Channel channel = doubleChannel(Gaussian(1).vector(40000, 1.0), 1e6);
    const auto bands = resolveBands(channel, 1, start, {}, ResponseTreatment::StepDeflated, {});
    QCOMPARE(bands.has_value(), begin >= 0);
    if (bands)
        QVERIFY((bands->baseline == SampleRange{begin, end}));
    else
        QCOMPARE(bands.error().findingId, std::string("WIN-002"));
}

void TestResponseWindow::baseline_null_subtractsNothing()
{
    WindowSettings settings;
    settings.start_s = {0.0};
    settings.subtractBaseline = false;
    const Eigen::VectorXd values = stepRecord(0.0).values().tail(36000); // no rest before
    const auto result = cut(doubleChannel(values, 10e6), settings);
    const WindowedResponse &r = only(result);
    QCOMPARE(r.startSample, Index(0));
    QVERIFY(!r.startDetected);
    QCOMPARE(r.baseline, 0.0);
    QCOMPARE(r.noiseSd, 0.0);
    QCOMPARE(r.snr_dB, std::numeric_limits<double>::infinity());
    QCOMPARE(r.noise.size(), Index(0));
    QCOMPARE(r.lead, Index(0));
    QVERIFY(std::abs(r.step - 2.7) < 1e-9);
    QVERIFY((r.values * r.step - values).cwiseAbs().maxCoeff() < 1e-14);
}

void TestResponseWindow::baseline_behindTheResponse_isUsed()
{
    // a decay typed to begin in its middle; the rest at the end is the only one
    const SecondOrder plate{804.0, 0.02};
    Eigen::VectorXd values = Gaussian(2).vector(5500, 1e-4);
    for (Index i = 0; i < 5500; ++i)
        values[i] += 0.75 + plate.decay(static_cast<double>(i) / 50e3);
    WindowSettings settings;
    settings.start_s = {0.002};
    settings.end_s = 0.04;
    settings.baseline_s = Interval{0.085, 0.105};
    const auto result = cut(doubleChannel(values, 50e3), settings, impulseContext());
    const WindowedResponse &r = only(result);
    QCOMPARE(r.startSample, Index(100));
    QCOMPARE(r.length, Index(2000));
    QCOMPARE(r.noise.size(), Index(1000));
    QVERIFY(std::abs(r.baseline - values.segment(4350, 1000).mean()) < 1e-15);
    QCOMPARE(r.lead, Index(100)); // all there is
    QCOMPARE(r.valueScale, 1.0);
    QVERIFY(std::abs(r.values[r.lead] - (values[100] - r.baseline)) < 1e-15);
}

void TestResponseWindow::baseline_wrongPlace_isBlocked()
{
    WindowSettings settings;
    settings.baseline_s = Interval{-1e-4, 1e-5};
    compareError(cut(stepChannel(), settings), "WIN-002", "overlaps");
    settings.baseline_s = Interval{1e-4, 2e-4};
    settings.end_s = 1e-3;
    compareError(cut(stepChannel(), settings), "WIN-002", "overlaps");
    settings.baseline_s = Interval{-1e-4, -9.8e-5};
    compareError(cut(stepChannel(), settings), "WIN-002", "needs at least 50");
    settings.baseline_s = Interval{-5e-4, -1e-4};
    compareError(cut(stepChannel(), settings), "WIN-002", "leaves the record");
    settings.baseline_s = Interval{-5.0, -4.0}; // far outside: said as it was typed
    compareError(cut(stepChannel(), settings), "WIN-002", "the baseline -5 s to -4 s leaves");
    settings.baseline_s = Interval{-1e300, -1e299};
    compareError(cut(stepChannel(), settings), "WIN-002", "leaves the record");
    settings.baseline_s = Interval{-3e-4, -1e-4};
    QCOMPARE(only(cut(stepChannel(), settings)).noise.size(), Index(2000));
}

void TestResponseWindow::end_plateauThatFalls_isNinetyPercent_data()
{
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("fall_s"); ///< behind the arrival
    QTest::addColumn<double>("depth");
    for (const double noise : {0.0, 0.002, 0.05}) {
        for (const double fall_s : {0.4e-3, 1.63e-3, 3e-3}) {
            for (const double depth : {-0.6, 0.3})
                QTest::addRow("noise %g, at %g s, %g", noise, fall_s, depth)
                    << noise << fall_s << depth;
        }
    }
}

void TestResponseWindow::end_plateauThatFalls_isNinetyPercent()
{
    QFETCH(double, noise);
    QFETCH(double, fall_s);
    QFETCH(double, depth);
    StepRecord record = stepRecord(noise);
    record.duration_s = 20e-3;
    Eigen::VectorXd values = record.values();
    for (Index i = 0; i < values.size(); ++i) {
        const double t_s = static_cast<double>(i) / 10e6 - record.arrival_s - fall_s;
        if (t_s > 0.0)
            values[i] += record.step * depth * (1.0 - std::exp(-t_s / 1e-3));
    }
    const auto result = cut(doubleChannel(values, 10e6));
    const WindowedResponse &r = only(result);
    // to a block of 0.02 ms; where noise hides the first 3 % of the fall, 0.05 to 0.11 ms late
    const double late_s = noise > 0.01 ? 0.2e-3 : 0.06e-3;
    QVERIFY2(r.end_s >= 0.9 * (fall_s - 0.02e-3) && r.end_s <= 0.9 * (fall_s + late_s),
        qPrintable(QString::number(r.end_s)));
    QVERIFY(std::abs(r.step / 2.5 - 1.0) < 0.02);
}

void TestResponseWindow::end_slowRinging_isNotADeparture_data()
{
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("zeta");
    for (const double f0_Hz : {3e3, 6e3, 12e3, 50e3, 1e6}) {
        for (const double zeta : {0.005, 0.02, 0.2, 0.7})
            QTest::addRow("%g Hz, zeta %g", f0_Hz, zeta) << f0_Hz << zeta;
    }
}

void TestResponseWindow::end_slowRinging_isNotADeparture()
{
    QFETCH(double, f0_Hz);
    QFETCH(double, zeta);
    StepRecord record = stepRecord(0.002);
    record.sensor = {f0_Hz, zeta};
    const auto result = cut(doubleChannel(record.values(), 10e6));
    QCOMPARE(only(result).length, Index(40000) - only(result).startSample);
}

void TestResponseWindow::end_decay_isWhereNoiseBegins()
{
    const SecondOrder plate{5000.0, 0.05};
    Eigen::VectorXd values = Gaussian(3).vector(40000, 0.01);
    for (Index i = 2000; i < values.size(); ++i)
        values[i] += plate.decay(static_cast<double>(i - 2000) / 1e6);
    const auto result = cut(doubleChannel(values, 1e6), {}, impulseContext());
    // amplitude falls below the noise at ln(100)/(zeta w0) = 2.93 ms
    QVERIFY2(std::abs(only(result).end_s - 2.93e-3) < 0.6e-3,
        qPrintable(QString::number(only(result).end_s)));
    QVERIFY(only(result).settle_s == Interval{});
}

void TestResponseWindow::end_lateBaseline_limitsTheWindow()
{
    WindowSettings settings;
    settings.start_s = {0.0};
    settings.baseline_s = Interval{3e-3, 3.5e-3};
    Eigen::VectorXd values = stepRecord().values();
    values.segment(4000, 30000) = Gaussian(8).vector(30000, 1.0);
    const auto result = cut(doubleChannel(values, 10e6, -4e-4), settings, impulseContext());
    QCOMPARE(only(result).length, Index(30000));
}

void TestResponseWindow::end_typedBeyondRecord_namesTheLargest()
{
    WindowSettings settings;
    settings.start_s = {0.0};
    settings.end_s = 3.6e-3;
    QCOMPARE(only(cut(stepChannel(), settings)).length, Index(36000));
    settings.end_s = 3.7e-3;
    const auto result = cut(stepChannel(), settings);
    compareError(result, "", "3.6 ms at most");
    QCOMPARE(result.error().kind, ErrorKind::DataBlocked);
    QCOMPARE(result.error().shot, Index(1));
    settings.end_s = 1e-6;
    compareError(cut(stepChannel(), settings), "", "needs at least 16");
    settings.end_s = -1.0;
    compareError(cut(stepChannel(), settings), "", "needs at least 16");
    settings.end_s = 1e300;
    compareError(cut(stepChannel(), settings), "", "3.6 ms at most");
}

void TestResponseWindow::end_ofEachShot_isItsOwn()
{
    CaptureSet set = captureSetOf({stepChannel(), stepChannel(), stepChannel()});
    WindowSettings settings;
    settings.start_s = {0.0};
    settings.end_s = 1e-3; // the common one: without effect
    settings.ownEnds_s = {1.2e-3, Auto<double>(), 2e-3};
    const auto result = cutWindows(set, settings, {});
    QVERIFY(result.has_value());
    WindowSettings automatic;
    automatic.start_s = {0.0};
    const Index usual = only(cut(stepChannel(), automatic)).length;
    QCOMPARE(result->responses[0].length, Index(12000));
    QCOMPARE(result->responses[1].length, usual);
    QCOMPARE(result->responses[2].length, Index(20000));
    set.shots[1].included = false; // the others keep theirs
    const auto fewer = cutWindows(set, settings, {});
    QVERIFY(fewer.has_value());
    QCOMPARE(fewer->responses[1].length, Index(20000));
    settings.ownEnds_s[2] = 3.7e-3; // beyond that shot's record
    compareError(cutWindows(set, settings, {}), "", "Shot 3 ends");
}

void TestResponseWindow::end_plateau_isTakenFromShockData()
{
    WindowSettings settings;
    settings.start_s = {0.0};
    settings.endAtPlateau = true;
    compareError(cut(stepChannel(), settings), "", "no shock data");
    WindowContext context;
    context.plateau_s = {1.5e-3};
    QCOMPARE(only(cut(stepChannel(), settings, context)).length, Index(15000));
    context.plateau_s = {1.0}; // longer than the record: as far as it goes
    QCOMPARE(only(cut(stepChannel(), settings, context)).length, Index(36000));
}

void TestResponseWindow::settle_typed_mustLieInside()
{
    WindowSettings settings;
    settings.start_s = {0.0};
    settings.end_s = 1.5e-3;
    settings.settle_s = Interval{8e-4, 1.4e-3};
    const auto result = cut(stepChannel(), settings);
    QVERIFY(std::abs(only(result).settle_s.begin - 8e-4) < 1e-12);
    QVERIFY(std::abs(only(result).settle_s.end - 1.4e-3) < 1e-12);
    settings.settle_s = Interval{8e-4, 1.6e-3};
    compareError(cut(stepChannel(), settings), "", "settle band");
    settings.settle_s = Interval{-1e-4, 1e-3};
    compareError(cut(stepChannel(), settings), "", "settle band");
}

void TestResponseWindow::start_typed_oneOrPerShot()
{
    StepRecord late = stepRecord();
    late.arrival_s = 6e-4;
    const CaptureSet set = captureSetOf({stepChannel(), doubleChannel(late.values(), 10e6, -4e-4)});
    WindowSettings settings;
    settings.start_s = {0.0, 2e-4};
    auto result = cutWindows(set, settings, {});
    QVERIFY(result.has_value());
    QCOMPARE(result->responses[0].startSample, Index(4000));
    QCOMPARE(result->responses[1].startSample, Index(6000));
    settings.start_s = {2.00004e-4}; // nearest sample
    settings.baseline_s = Interval{-5e-4, -2.1e-4};
    result = cutWindows(set, settings, {});
    QVERIFY(result.has_value());
    QCOMPARE(result->responses[0].startSample, Index(6000));
    QCOMPARE(result->responses[1].start_s, 2e-4);
}

void TestResponseWindow::start_typedOutside_isBlocked()
{
    WindowSettings settings;
    for (const double start_s : {-5e-4, 4e-3, 1e300, -1e300}) {
        settings.start_s = {start_s};
        compareError(cut(stepChannel(), settings), "", "outside the record");
    }
    settings.start_s = {3.5999e-3};
    compareError(cut(stepChannel(), settings), "", "needs at least 16");
}

DYNCAL_TEST(TestResponseWindow)
#include "tst_response_window.moc"
