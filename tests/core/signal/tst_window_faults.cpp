// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is wrong with a record, and how the window says so.

#include "core/signal/response_window.h"
#include "core/signal/window_bands.h"
#include "core/signal/window_checks.h"
#include "core/signal/window_cutting.h"
#include "tests/core/signal/window_records.h"
#include "tests/support/measured_data.h"
#include "tests/support/test_program.h"

#include <cmath>
#include <stop_token>

using namespace dyncal;
using namespace dyncal::testing;

class TestWindowFaults : public QObject
{
    Q_OBJECT

private slots:
    void settings_nonsense_isUsage();
    void invalidSamples_blockInsideOnly();
    void margins_stopAtInvalidSamples();
    void saturation_knownRails_blockInsideOnly();
    void saturation_beforeTheConverter_isACaution();
    void saturation_unknownRails_isACaution_data();
    void saturation_unknownRails_isACaution();
    void runAtExtreme_smoothPeaks_areNotSaturated();
    void findings_negativeStep();
    void findings_fewCodes();
    void findings_driftingLevels();
    void findings_driftOverALongBaseline();
    void findings_lowSnr_namesTheAttainableFit();
    void findings_windowBehindPlateau();
    void findings_windowBehindPlateau_ofOneShot();
    void restlessBaseline_leavesTheShotOut();
    void noStep_isBlockedWithItsShot();
    void everyBadShot_isToldAtOnce();
    void noDut_isBlocked();
    void shots_excluded_keepTheirNumbers();
    void impulse_measuresThePeak();
    void counts_noiseIsAtLeastQuantisation();
    void stopRequested_isCancelled();
    void progress_reachesOne();
    void measured_impact_matchesIndependentBaseline();
    void measured_badShot_isLeftOut();
};

void TestWindowFaults::settings_nonsense_isUsage()
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
    settings = {};
    settings.ownEnds_s = {1e-3, 2e-3}; // of one shot
    QCOMPARE(cut(stepChannel(), settings).error().kind, ErrorKind::Usage);
    settings.ownEnds_s = {kNan};
    QCOMPARE(cut(stepChannel(), settings).error().kind, ErrorKind::Usage);
    QCOMPARE(cutWindows({}, {}, {}).error().kind, ErrorKind::Usage);
}

void TestWindowFaults::invalidSamples_blockInsideOnly()
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

void TestWindowFaults::margins_stopAtInvalidSamples()
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

void TestWindowFaults::saturation_knownRails_blockInsideOnly()
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

/// The converter has room, the amplifier before it has none.
void TestWindowFaults::saturation_beforeTheConverter_isACaution()
{
    const Eigen::VectorXd values = stepRecord().values();
    QVERIFY(!findingOf(cut(countsChannel(values, 10e6, 10.0, 14)), "CAP-007"));
    const auto result = cut(countsChannel(values.cwiseMin(4.0), 10e6, 10.0, 14));
    QVERIFY(result.has_value());
    QVERIFY(findingOf(result, "CAP-007"));
    QCOMPARE(findingOf(result, "CAP-007")->severity, Severity::Caution);
}

void TestWindowFaults::saturation_unknownRails_isACaution_data()
{
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("limit");
    QTest::addColumn<bool>("clipped");
    for (const double f0_Hz : {30e3, 300e3, 1e6}) {
        QTest::addRow("%g Hz, clipped", f0_Hz) << f0_Hz << 4.0 << true;
        QTest::addRow("%g Hz, whole", f0_Hz) << f0_Hz << 10.0 << false;
    }
}

void TestWindowFaults::saturation_unknownRails_isACaution()
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

void TestWindowFaults::runAtExtreme_smoothPeaks_areNotSaturated()
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

void TestWindowFaults::findings_negativeStep()
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

void TestWindowFaults::findings_fewCodes()
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

void TestWindowFaults::findings_driftingLevels()
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

/// Slow, but the baseline is long: 0.1 % per ms over 20 ms.
void TestWindowFaults::findings_driftOverALongBaseline()
{
    constexpr double kRate_Hz = 2e5;
    const StepRecord record = stepRecord();
    const auto drifting = [&](double per_ms) {
        Eigen::VectorXd values = record.values();
        for (Index i = 0; i < 4000; ++i)
            values[i] += record.step * per_ms * 1e3 * static_cast<double>(i - 4000) / kRate_Hz;
        return cut(doubleChannel(values, kRate_Hz));
    };
    QVERIFY(!findingOf(drifting(0.0), "WIN-004"));
    QVERIFY(!findingOf(drifting(0.0001), "WIN-004"));
    QVERIFY(findingOf(drifting(0.001), "WIN-004"));
}

void TestWindowFaults::findings_lowSnr_namesTheAttainableFit()
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

void TestWindowFaults::findings_windowBehindPlateau()
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

/// The correction moves the end of the shot that it is about, where each has its own.
void TestWindowFaults::findings_windowBehindPlateau_ofOneShot()
{
    const CaptureSet set = captureSetOf({stepChannel(), stepChannel(), stepChannel()});
    WindowSettings settings;
    settings.ownEnds_s = {Auto<double>(), 2e-3, 1.5e-3};
    WindowContext context;
    context.plateau_s = {1.63e-3, 1.63e-3, 1.63e-3};
    const auto result = cutWindows(set, settings, context);
    QVERIFY(result.has_value());
    QCOMPARE(std::ranges::count(result->findings, std::string("WIN-001"), &Finding::id), 1);
    const Finding *finding = findingOf(result, "WIN-001");
    QVERIFY(finding && finding->correction);
    QCOMPARE(finding->shot, Index(2));
    QCOMPARE(english(finding->correction->label), std::string("Move the end of shot 2 to 1.63 ms"));
    QCOMPARE(finding->correction->key, std::string("window.end_s"));
    QCOMPARE(finding->correction->value, std::string("[\"auto\", 0.00163, 0.0015]"));
    settings.ownEnds_s[1] = 1.63e-3; // as the correction has it
    QVERIFY(!findingOf(cutWindows(set, settings, context), "WIN-001"));
}

void TestWindowFaults::restlessBaseline_leavesTheShotOut()
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

void TestWindowFaults::noStep_isBlockedWithItsShot()
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

/// Nobody mends one shot only to be told of the next.
void TestWindowFaults::everyBadShot_isToldAtOnce()
{
    WindowSettings settings;
    settings.start_s = {4e-4};
    settings.end_s = 2e-3;
    settings.baseline_s = Interval{-2e-4, -1e-5};
    Eigen::VectorXd holed = stepRecord().values();
    holed[4100] = kNan;
    const Channel clipped = countsChannel(stepRecord().values(), 10e6, 4.0, 14);
    CaptureSet set = captureSetOf({doubleChannel(holed, 10e6),
        doubleChannel(stepRecord().values(), 10e6), clipped, doubleChannel(holed, 10e6)});
    const auto result = cutWindows(set, settings, {});
    compareError(result, "CAP-006", "Shot 1");
    const std::vector<Error> &further = result.error().further;
    QCOMPARE(further.size(), std::size_t(2));
    QCOMPARE(further[0].findingId, std::string("CAP-007"));
    QCOMPARE(further[0].shot, Index(3));
    QCOMPARE(further[1].findingId, std::string("CAP-006"));
    QCOMPARE(further[1].shot, Index(4));
    for (const std::size_t bad : {0, 2, 3})
        set.shots[bad].included = false;
    QVERIFY(cutWindows(set, settings, {}).has_value());
}

void TestWindowFaults::noDut_isBlocked()
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

void TestWindowFaults::shots_excluded_keepTheirNumbers()
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

void TestWindowFaults::impulse_measuresThePeak()
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

void TestWindowFaults::counts_noiseIsAtLeastQuantisation()
{
    const StepRecord record = stepRecord(0.0);
    const auto result = cut(countsChannel(record.values(), 10e6, 5.0, 10));
    const double code = 10.0 / 1024.0;
    QVERIFY(std::abs(only(result).noiseSd / (code / std::sqrt(12.0)) - 1.0) < 1e-9);
    QVERIFY(std::isfinite(only(result).snr_dB));
}

void TestWindowFaults::stopRequested_isCancelled()
{
    std::stop_source source;
    source.request_stop();
    const auto result = cutWindows(captureSetOf({stepChannel()}), {}, {}, {source.get_token(), {}});
    QVERIFY(!result);
    QCOMPARE(result.error().kind, ErrorKind::Cancelled);
}

void TestWindowFaults::progress_reachesOne()
{
    std::vector<double> seen;
    JobControl control;
    control.progress = [&](double fraction) { seen.push_back(fraction); };
    QVERIFY(cutWindows(captureSetOf({stepChannel(), stepChannel()}), {}, {}, control).has_value());
    QCOMPARE(seen, (std::vector<double>{0.5, 1.0}));
}

void TestWindowFaults::measured_impact_matchesIndependentBaseline()
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

void TestWindowFaults::measured_badShot_isLeftOut()
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

DYNCAL_TEST(TestWindowFaults)
#include "tst_window_faults.moc"
