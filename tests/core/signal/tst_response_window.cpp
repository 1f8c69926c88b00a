// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/response_window.h"
#include "core/signal/window_bands.h"
#include "core/signal/window_checks.h"
#include "core/signal/window_cutting.h"
#include "tests/support/measured_data.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <stop_token>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// 40 000 samples at 10 MS/s, arrival at sample 4000, 300 kHz, level 0.2 to 2.7.
StepRecord stepRecord(double noise = 0.001)
{
    StepRecord record;
    record.sensor = {300e3, 0.1};
    record.baseline = 0.2;
    record.step = 2.5;
    record.noiseSd = 2.5 * noise;
    return record;
}

Channel stepChannel(double noise = 0.001)
{
    return doubleChannel(stepRecord(noise).values(), 10e6, -4e-4);
}

Result<WindowResult> cut(
    const Channel &channel, const WindowSettings &settings = {}, const WindowContext &context = {})
{
    return cutWindows(captureSetOf({channel}), settings, context);
}

/// Unpacks a result that must be there, with one response.
const WindowedResponse &only(const Result<WindowResult> &result)
{
    static const WindowedResponse none;
    if (!result)
        qWarning("%s", english(result.error().message).c_str());
    return result && result->responses.size() == 1 ? result->responses[0] : none;
}

void compareError(const Result<WindowResult> &result, const char *id, const char *words)
{
    QVERIFY(!result);
    QCOMPARE(result.error().findingId, std::string(id));
    const std::string text = english(result.error().message);
    QVERIFY2(text.find(words) != std::string::npos, text.c_str());
    QVERIFY2(
        text.find("%1") == std::string::npos && text.find("%3") == std::string::npos, text.c_str());
}

const Finding *findingOf(const Result<WindowResult> &result, const std::string &id)
{
    for (const Finding &finding : result->findings) {
        if (finding.id == id)
            return &finding;
    }
    return nullptr;
}

WindowContext impulseContext()
{
    WindowContext context;
    context.treatment = ResponseTreatment::Impulse;
    return context;
}

} // namespace

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
    void end_plateau_isTakenFromShockData();
    void settle_typed_mustLieInside();
    void start_typed_oneOrPerShot();
    void start_typedOutside_isBlocked();
    void settings_nonsense_isUsage();
    void invalidSamples_blockInsideOnly();
    void margins_stopAtInvalidSamples();
    void saturation_knownRails_blockInsideOnly();
    void saturation_unknownRails_isACaution_data();
    void saturation_unknownRails_isACaution();
    void runAtExtreme_smoothPeaks_areNotSaturated();
    void findings_negativeStep();
    void findings_fewCodes();
    void findings_driftingLevels();
    void findings_lowSnr_namesTheAttainableFit();
    void findings_windowBehindPlateau();
    void restlessBaseline_leavesTheShotOut();
    void noStep_isBlockedWithItsShot();
    void noDut_isBlocked();
    void shots_excluded_keepTheirNumbers();
    void impulse_measuresThePeak();
    void counts_noiseIsAtLeastQuantisation();
    void stopRequested_isCancelled();
    void progress_reachesOne();
    void measured_impact_matchesIndependentBaseline();
    void measured_badShot_isLeftOut();
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
    // seen when 3 % of the step is passed: 0.05 to 0.11 ms late, plus blocks of 0.02 ms
    QVERIFY2(r.end_s >= 0.88 * fall_s && r.end_s <= 0.9 * (fall_s + 0.2e-3),
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

void TestResponseWindow::settings_nonsense_isUsage()
{
    WindowSettings settings;
    settings.start_s = {0.0, 1.0};
    QCOMPARE(cut(stepChannel(), settings).error().kind, ErrorKind::Usage);
    settings.start_s = {kNan};
    QCOMPARE(cut(stepChannel(), settings).error().kind, ErrorKind::Usage);
    settings = {};
    settings.baseline_s = Interval{-1e-4, -2e-4};
    QCOMPARE(cut(stepChannel(), settings).error().kind, ErrorKind::Usage);
    settings = {};
    settings.settle_s = Interval{1e-4, kNan};
    QCOMPARE(cut(stepChannel(), settings).error().kind, ErrorKind::Usage);
    settings = {};
    settings.end_s = std::numeric_limits<double>::infinity();
    QCOMPARE(cut(stepChannel(), settings).error().kind, ErrorKind::Usage);
    QCOMPARE(cutWindows({}, {}, {}).error().kind, ErrorKind::Usage);
}

void TestResponseWindow::invalidSamples_blockInsideOnly()
{
    WindowSettings settings;
    settings.start_s = {4e-4};
    settings.end_s = 2e-3;
    settings.baseline_s = Interval{-2e-4, -1e-5};
    const auto withInvalid = [&](Index at) {
        Eigen::VectorXd values = stepRecord().values();
        values[at] = kNan;
        return cut(doubleChannel(values, 10e6), settings);
    };
    for (const Index inside : {2000, 3899, 3950, 4000, 23999}) {
        const auto result = withInvalid(inside);
        compareError(result, "CAP-006", ("sample " + std::to_string(inside)).c_str());
        QCOMPARE(result.error().shot, Index(1));
    }
    for (const Index outside : {0, 1999, 24000, 39999})
        QVERIFY(withInvalid(outside).has_value());
}

void TestResponseWindow::margins_stopAtInvalidSamples()
{
    WindowSettings settings;
    settings.start_s = {4e-4};
    settings.end_s = 2e-3;
    settings.baseline_s = Interval{-2e-4, -1e-5};
    Eigen::VectorXd values = stepRecord().values();
    values[1500] = kNan;
    values[24100] = kNan;
    const auto result = cut(doubleChannel(values, 10e6), settings);
    const WindowedResponse &r = only(result);
    QVERIFY(r.values.allFinite());
    QCOMPARE(r.lead, Index(4000 - 1501));
    QCOMPARE(r.values.size(), r.lead + 20100);
}

void TestResponseWindow::saturation_knownRails_blockInsideOnly()
{
    StepRecord record = stepRecord(); // peaks at 0.2 + 2.5 * 1.73 = 4.52
    QVERIFY(cut(countsChannel(record.values(), 10e6, 5.0, 14)).has_value());
    const auto clipped = cut(countsChannel(record.values(), 10e6, 4.0, 14));
    compareError(clipped, "CAP-007", "saturated");
    // clipped before a typed start: must work
    WindowSettings settings;
    settings.start_s = {6e-4};
    settings.baseline_s = Interval{-5e-4, -2.1e-4};
    QVERIFY(cut(countsChannel(record.values(), 10e6, 4.0, 14), settings).has_value());
    record.baseline = -6.0; // baseline at the lower rail
    settings = {};
    compareError(
        cut(countsChannel(record.values(), 10e6, 5.0, 14), settings), "CAP-007", "saturated");
}

void TestResponseWindow::saturation_unknownRails_isACaution_data()
{
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("limit");
    QTest::addColumn<bool>("clipped");
    for (const double f0_Hz : {30e3, 300e3, 1e6}) {
        QTest::addRow("%g Hz, clipped", f0_Hz) << f0_Hz << 4.0 << true;
        QTest::addRow("%g Hz, whole", f0_Hz) << f0_Hz << 10.0 << false;
    }
}

void TestResponseWindow::saturation_unknownRails_isACaution()
{
    QFETCH(double, f0_Hz);
    QFETCH(double, limit);
    QFETCH(bool, clipped);
    StepRecord record = stepRecord();
    record.sensor.f0_Hz = f0_Hz;
    const auto result = cut(doubleChannel(record.values().cwiseMin(limit), 10e6));
    QVERIFY(result.has_value());
    QCOMPARE(findingOf(result, "CAP-007") != nullptr, clipped);
    if (clipped)
        QCOMPARE(findingOf(result, "CAP-007")->severity, Severity::Caution);
}

void TestResponseWindow::runAtExtreme_smoothPeaks_areNotSaturated()
{
    for (const double perPeriod : {8.0, 50.0, 500.0, 20000.0}) {
        for (const double code : {0.0, 0.001, 0.02}) { // coarse codes make flat tops
            const Eigen::VectorXd sine = Eigen::VectorXd::NullaryExpr(30000, [&](Index i) {
                const double y
                    = std::sin(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.3) / perPeriod);
                return code > 0.0 ? code * std::nearbyint(y / code) : y;
            });
            const double noise = code / std::sqrt(12.0);
            QVERIFY(perPeriod < 20.0 || !runAtExtreme(sine, noise, code));
        }
    }
    QVERIFY(!runAtExtreme(Eigen::VectorXd(), 0.1, 0.0));
}

void TestResponseWindow::findings_negativeStep()
{
    StepRecord record = stepRecord();
    record.step = -2.5;
    const auto result = cut(doubleChannel(record.values(), 10e6));
    QVERIFY(std::abs(only(result).step + 2.5) < 0.01);
    QVERIFY(findingOf(result, "CAP-012"));
    QCOMPARE(findingOf(result, "CAP-012")->severity, Severity::Caution);
    // remapped to 0..1 all the same
    QVERIFY(std::abs(only(result).window().tail(1000).mean() - 1.0) < 1e-3);
    QVERIFY(*only(result).overshoot_percent > 70.0);
    QVERIFY(only(result).snr_dB > 55.0);
}

void TestResponseWindow::findings_fewCodes()
{
    StepRecord record = stepRecord();
    record.baseline = 0.0;
    const double fullScale = 2.5 * 128.0 / 50.0; // step of 50 codes at 8 bits
    const auto few = cut(countsChannel(record.values(), 10e6, fullScale, 8));
    QVERIFY(findingOf(few, "CAP-014"));
    QVERIFY(std::abs(*findingOf(few, "CAP-014")->value - 50.0) < 0.5);
    QCOMPARE(*findingOf(few, "CAP-014")->limit, 64.0);
    QVERIFY(!findingOf(cut(countsChannel(record.values(), 10e6, fullScale, 9)), "CAP-014"));
}

void TestResponseWindow::findings_driftingLevels()
{
    const auto drifting = [](double before_per_ms, double behind_per_ms) {
        StepRecord record = stepRecord();
        Eigen::VectorXd values = record.values();
        for (Index i = 0; i < values.size(); ++i) {
            const double t_ms = static_cast<double>(i - 4000) / 1e4;
            values[i] += record.step * t_ms * (t_ms < 0.0 ? before_per_ms : behind_per_ms);
        }
        WindowSettings settings;
        settings.end_s = 2e-3;
        return cut(doubleChannel(values, 10e6), settings);
    };
    QVERIFY(!findingOf(drifting(0.0, 0.005), "WIN-003"));
    const auto settle = drifting(0.0, 0.02);
    QVERIFY(findingOf(settle, "WIN-003") && !findingOf(settle, "WIN-004"));
    QVERIFY(std::abs(*findingOf(settle, "WIN-003")->value - 2.0) < 0.1); // percent per ms
    QVERIFY(!findingOf(drifting(0.002, 0.0), "WIN-004"));
    const auto baseline = drifting(0.02, 0.0);
    QVERIFY(findingOf(baseline, "WIN-004") && !findingOf(baseline, "WIN-003"));
}

void TestResponseWindow::findings_lowSnr_namesTheAttainableFit()
{
    QVERIFY(!findingOf(cut(stepChannel(0.08)), "WIN-006"));
    const auto result = cut(stepChannel(0.15));
    QVERIFY(result.has_value());
    const Finding *finding = findingOf(result, "WIN-006");
    QVERIFY(finding);
    QVERIFY(std::abs(*finding->value - only(result).snr_dB) < 1e-12);
    QVERIFY(std::abs(*finding->value + 20.0 * std::log10(0.15)) < 0.6);
    QVERIFY(english(finding->message).find("FIT of about") != std::string::npos);
    QVERIFY(!only(result).riseTime_s);
}

void TestResponseWindow::findings_windowBehindPlateau()
{
    WindowSettings settings;
    settings.end_s = 2e-3;
    WindowContext context;
    context.plateau_s = {1.63e-3};
    const auto result = cut(stepChannel(), settings, context);
    QVERIFY(findingOf(result, "WIN-001"));
    QVERIFY(std::abs(*findingOf(result, "WIN-001")->value - 2e-3) < 1e-12);
    QCOMPARE(*findingOf(result, "WIN-001")->limit, 1.63e-3);
    QVERIFY(findingOf(result, "WIN-001")->correction.has_value());
    QCOMPARE(findingOf(result, "WIN-001")->correction->key, std::string("window.end_s"));
    QCOMPARE(findingOf(result, "WIN-001")->correction->value, std::string("0.00163"));
    settings.end_s = 1.63e-3; // as the correction has it
    QVERIFY(!findingOf(cut(stepChannel(), settings, context), "WIN-001"));
    settings.end_s = 1.6e-3;
    QVERIFY(!findingOf(cut(stepChannel(), settings, context), "WIN-001"));
}

void TestResponseWindow::restlessBaseline_leavesTheShotOut()
{
    Eigen::VectorXd restless = stepRecord().values();
    for (Index i = 0; i < restless.size(); ++i)
        restless[i] += 20.0 * std::exp(-static_cast<double>(i) / 4000.0);
    const auto both
        = cutWindows(captureSetOf({stepChannel(), doubleChannel(restless, 10e6, -4e-4)}), {}, {});
    QVERIFY(both.has_value());
    QCOMPARE(both->responses.size(), std::size_t(1));
    QCOMPARE(both->responses[0].shot, Index(1));
    const Finding *finding = findingOf(both, "CAP-020");
    QVERIFY(finding);
    QCOMPARE(finding->severity, Severity::Block);
    QCOMPARE(finding->shot, Index(2));

    const auto alone = cut(doubleChannel(restless, 10e6));
    compareError(alone, "CAP-020", "not at rest");
    QCOMPARE(alone.error().kind, ErrorKind::DataBlocked);
    WindowSettings settings; // an operator who knows better
    settings.start_s = {4e-4};
    settings.baseline_s = Interval{-2e-5, -1e-5};
    QVERIFY(cut(doubleChannel(restless, 10e6), settings).has_value());
}

void TestResponseWindow::noStep_isBlockedWithItsShot()
{
    const CaptureSet set
        = captureSetOf({stepChannel(), doubleChannel(Gaussian(5).vector(40000, 1.0), 10e6)});
    auto result = cutWindows(set, {}, {});
    compareError(result, "CAP-009", "Shot 2");
    QCOMPARE(result.error().shot, Index(2));
    WindowSettings settings;
    settings.start_s = {4e-4};
    compareError(cut(set.shots[1].channels[0], settings), "CAP-009", "tell it from noise");
    compareError(
        cut(doubleChannel(Eigen::VectorXd::Zero(40000), 10e6), settings), "CAP-009", "no step");
}

void TestResponseWindow::noDut_isBlocked()
{
    Channel channel = stepChannel();
    channel.role = ChannelRole::Other;
    compareError(cut(channel), "CAP-002", "no DUT");
    channel.role = ChannelRole::Dut;
    channel.sampleRate_Hz = 0.0;
    compareError(cut(channel), "", "sample_rate_hz");
    compareError(cut(doubleChannel(Eigen::VectorXd(), 10e6)), "CAP-009", "0 samples");
    WindowSettings settings;
    settings.start_s = {0.0};
    compareError(cut(doubleChannel(Eigen::VectorXd(), 10e6), settings), "", "outside the record");
}

void TestResponseWindow::shots_excluded_keepTheirNumbers()
{
    CaptureSet set = captureSetOf({stepChannel(), stepChannel(), stepChannel(0.002)});
    set.shots[1].included = false;
    set.shots[2].level = ShotLevel::High;
    const auto result = cutWindows(set, {}, {});
    QVERIFY(result.has_value());
    QCOMPARE(result->responses.size(), std::size_t(2));
    QCOMPARE(result->responses[1].shot, Index(3));
    QCOMPARE(result->responses[1].level, ShotLevel::High);
}

void TestResponseWindow::impulse_measuresThePeak()
{
    Eigen::VectorXd values = Gaussian(6).vector(4000, 1e-4);
    const SecondOrder plate{20e3, 0.02};
    for (Index i = 400; i < values.size(); ++i)
        values[i] += 0.5 - 3.0 * plate.decay(static_cast<double>(i - 400) / 1e6);
    values.head(400).array() += 0.5;
    const auto result = cut(doubleChannel(values, 1e6), {}, impulseContext());
    const WindowedResponse &r = only(result);
    Index peak = 0;
    (values.array() - r.baseline).abs().maxCoeff(&peak);
    QCOMPARE(r.step, values[peak] - r.baseline);
    QVERIFY(r.step < -2.5);
    QCOMPARE(r.settled, 0.0);
    QCOMPARE(r.valueScale, 1.0);
    QVERIFY(!r.riseTime_s && !r.overshoot_percent && !r.settlingTime_s);
    QVERIFY(!findingOf(result, "CAP-012"));
}

void TestResponseWindow::counts_noiseIsAtLeastQuantisation()
{
    const StepRecord record = stepRecord(0.0);
    const auto result = cut(countsChannel(record.values(), 10e6, 5.0, 10));
    const double code = 10.0 / 1024.0;
    QVERIFY(std::abs(only(result).noiseSd / (code / std::sqrt(12.0)) - 1.0) < 1e-9);
    QVERIFY(std::isfinite(only(result).snr_dB));
}

void TestResponseWindow::stopRequested_isCancelled()
{
    std::stop_source source;
    source.request_stop();
    const auto result = cutWindows(captureSetOf({stepChannel()}), {}, {}, {source.get_token(), {}});
    QVERIFY(!result);
    QCOMPARE(result.error().kind, ErrorKind::Cancelled);
}

void TestResponseWindow::progress_reachesOne()
{
    std::vector<double> seen;
    JobControl control;
    control.progress = [&](double fraction) { seen.push_back(fraction); };
    QVERIFY(cutWindows(captureSetOf({stepChannel(), stepChannel()}), {}, {}, control).has_value());
    QCOMPARE(seen, (std::vector<double>{0.5, 1.0}));
}

void TestResponseWindow::measured_impact_matchesIndependentBaseline()
{
    const auto values = textColumn(dataFolder()
            / "highrate_ds5_impact/data/dataset-1/data-1/PCB_repeated_shock_trials/acc_pcb_a0.txt",
        1);
    if (!values)
        DYNCAL_SKIP_WITHOUT_DATA("Measured data are missing: set DYNCAL_DATA");
    WindowSettings settings; // as in expected/ds5_era.json
    settings.start_s = {0.025};
    settings.end_s = 0.04;
    settings.baseline_s = Interval{0.065, 0.085};
    const auto result = cut(doubleChannel(*values, 50e3), settings, impulseContext());
    const WindowedResponse &r = only(result);
    QCOMPARE(r.startSample, Index(1250));
    QCOMPARE(r.length, Index(2000));
    const double mean = values->tail(1000).mean();
    QVERIFY(std::abs(r.baseline - mean) < 1e-14);
    QVERIFY(std::abs(r.window()[7] - ((*values)[1257] - mean)) < 1e-12);
    QVERIFY(!hasFinding(result->findings, "CAP-007")); // clipped, but before the window
}

void TestResponseWindow::measured_badShot_isLeftOut()
{
    std::vector<Channel> channels;
    for (const char *name : {"Test_001.lvm", "Test_017.lvm"}) {
        const auto values
            = textColumn(dataFolder() / "highrate_ds5_impact/data/dataset-2/data-1" / name, 1,
                "***End_of_Header***");
        if (!values)
            DYNCAL_SKIP_WITHOUT_DATA("Measured data are missing: set DYNCAL_DATA");
        channels.push_back(doubleChannel(*values, 51200.0));
    }
    const auto result = cutWindows(captureSetOf(channels), {}, impulseContext());
    QVERIFY(result.has_value());
    QCOMPARE(result->responses.size(), std::size_t(1));
    QVERIFY(findingOf(result, "CAP-020"));
    QCOMPARE(findingOf(result, "CAP-020")->shot, Index(2));
}

DYNCAL_TEST(TestResponseWindow)
#include "tst_response_window.moc"
