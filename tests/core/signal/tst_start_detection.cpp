// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/start_detection.h"
#include "tests/support/measured_data.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <stop_token>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A shock record as the simulator makes it, 2 M samples with 10 % before the step.
StepRecord shockRecord(double f0_Hz, double zeta, double noise)
{
    StepRecord record;
    record.sensor = {f0_Hz, zeta};
    record.rate_Hz = 100e6;
    record.duration_s = 0.02;
    record.arrival_s = 0.002000003;
    record.baseline = 0.1;
    record.noiseSd = noise;
    return record;
}

/// Time from the arrival on until a second order step response first exceeds `level`.
double riseTo_s(const SecondOrder &sensor, double level)
{
    double t_s = 0.0;
    while (sensor.step(t_s) < level)
        t_s += 1e-4 / sensor.f0_Hz;
    return t_s;
}

Eigen::VectorXd smallRecord(double noise = 0.0)
{
    StepRecord record;
    record.sensor = {30e3, 0.05};
    record.rate_Hz = 1e6;
    record.noiseSd = noise;
    return record.values(); // 4000 samples, arrival at 400
}

void compareStart(const Result<DetectedStart> &start, Index from, Index to)
{
    QVERIFY2(start.has_value(), start ? "" : english(start.error().message).c_str());
    const QString text = QString("found %1, wanted %2..%3").arg(start->sample).arg(from).arg(to);
    QVERIFY2(start->sample >= from && start->sample <= to, qPrintable(text));
}

void compareNoStart(const Result<DetectedStart> &start, const char *advice)
{
    QVERIFY2(!start, start ? qPrintable(QString::number(start->sample)) : "");
    QCOMPARE(start.error().kind, ErrorKind::DataBlocked);
    QCOMPARE(start.error().findingId, std::string("CAP-009"));
    const std::string text = english(start.error().message);
    QVERIFY2(text.find(advice) != std::string::npos, text.c_str());
    QVERIFY(text.find('%') == std::string::npos);
}

} // namespace

class TestStartDetection : public QObject
{
    Q_OBJECT

private slots:
    void detect_shockRecord_isCloseToArrival_data();
    void detect_shockRecord_isCloseToArrival();
    void detect_noiseFreeRecord_isFirstSampleAboveHalfPercent();
    void detect_knownNoise_isMeasuredWithinFivePercent();
    void detect_repeatedNoise_neverFails();
    void detect_coarseCodes_givesNoiseOfAtLeastACode();
    void detect_spikesBeforeStep_areIgnored_data();
    void detect_spikesBeforeStep_areIgnored();
    void detect_driftingBaseline_findsStep();
    void detect_strongDrift_isNotAtRest();
    void detect_invalidSamples_areSkipped();
    void detect_stepAtTheVeryEnd_staysInside();
    void detect_twoSteps_findsTheFirst();
    void detect_plateauThatEnds_findsTheStep();
    void detect_decay_findsItsBegin();
    void detect_noStep_isBlocked_data();
    void detect_noStep_isBlocked();
    void detect_noStep_saysWhatDecides_data();
    void detect_noStep_saysWhatDecides();
    void detect_startAtFirstSamples_isBlocked_data();
    void detect_startAtFirstSamples_isBlocked();
    void detect_shotNumber_isNamed();
    void detect_stopRequested_isCancelled();
    void detect_timeAxis_usesRecordOrigin();
    void detect_impactRecords_startBeforeTheirPeak();
    void detect_labviewRecords_startBeforeTheirPeak_data();
    void detect_labviewRecords_startBeforeTheirPeak();
    void detect_syntheticSeriesWithoutLead_isBlocked();
    void crossing_ramp_isExact();
    void crossing_noneOrInvalid_isEmpty();
    void crossing_acrossChunks_isFound();
};

void TestStartDetection::detect_shockRecord_isCloseToArrival_data()
{
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("step");
    for (const double f0_Hz : {2.33e6, 318e3, 50e3, 5e3}) {
        for (const double zeta : {0.02, 0.7}) {
            for (const double noise : {0.001, 0.01, 0.05, 0.2}) {
                for (const double step : {1.0, -0.25})
                    QTest::addRow("%g Hz, zeta %g, noise %g, step %g", f0_Hz, zeta, noise, step)
                        << f0_Hz << zeta << noise << step;
            }
        }
    }
}

void TestStartDetection::detect_shockRecord_isCloseToArrival()
{
    QFETCH(double, f0_Hz);
    QFETCH(double, zeta);
    QFETCH(double, noise);
    QFETCH(double, step);
    StepRecord record = shockRecord(f0_Hz, zeta, noise * std::abs(step));
    record.step = step;
    const auto start = detectStart(countsChannel(record.values(), record.rate_Hz, 2.5, 14));
    // No later than where the clean response has most of the step, at least twelve samples; and
    // no earlier than the smoothing that the noise makes necessary.
    const auto late = static_cast<Index>(riseTo_s(record.sensor, 0.7) * record.rate_Hz);
    const Index allowedEarly = noise > 0.04 ? 32 : 2;
    compareStart(start, 200001 - allowedEarly, 200001 + std::max<Index>(late, 12));
    if (QTest::currentTestFailed())
        return;
    QVERIFY(start->baselineAtRest);
    QVERIFY(std::abs(start->baseline - 0.1) < 0.1 * std::abs(step));
    QVERIFY(start->stepToNoise > 4.0);
}

void TestStartDetection::detect_noiseFreeRecord_isFirstSampleAboveHalfPercent()
{
    const Eigen::VectorXd values = smallRecord();
    const auto start = detectStart(doubleChannel(values, 1e6));
    const double height = values.maxCoeff();
    Index expected = 0;
    while (values[expected] <= 0.005 * height)
        ++expected;
    compareStart(start, expected, expected);
    QVERIFY(start->baselineAtRest);
    QCOMPARE(start->baseline, 0.0);
}

void TestStartDetection::detect_knownNoise_isMeasuredWithinFivePercent()
{
    constexpr double kSd = 0.013;
    StepRecord record = shockRecord(318e3, 0.02, kSd);
    const auto start = detectStart(doubleChannel(record.values(), record.rate_Hz));
    QVERIFY(start.has_value());
    QVERIFY(std::abs(start->noiseSd / kSd - 1.0) < 0.05); // 20000 samples: 1 % for a MAD
    QVERIFY(std::abs(start->baseline - 0.1) < 5.0 * kSd / std::sqrt(1000.0));
}

void TestStartDetection::detect_repeatedNoise_neverFails()
{
    StepRecord record;
    record.sensor = {30e3, 0.3};
    record.rate_Hz = 1e6;
    for (const double noise : {0.01, 0.1, 0.2}) {
        record.noiseSd = noise;
        for (record.seed = 1; record.seed <= 200; ++record.seed) {
            const auto start = detectStart(doubleChannel(record.values(), record.rate_Hz));
            compareStart(start, noise > 0.04 ? 372 : 398, 412);
            if (QTest::currentTestFailed())
                return;
        }
    }
}

void TestStartDetection::detect_coarseCodes_givesNoiseOfAtLeastACode()
{
    const auto start = detectStart(countsChannel(smallRecord(1e-5), 1e6, 2.0, 8));
    compareStart(start, 400, 404);
    QVERIFY(start->noiseSd >= 2.0 / 128.0 / std::sqrt(12.0) * (1.0 - 1e-12));
}

void TestStartDetection::detect_spikesBeforeStep_areIgnored_data()
{
    QTest::addColumn<double>("noise");
    QTest::addColumn<int>("position");
    for (const double noise : {0.0, 0.001, 0.01}) {
        for (const int position : {5, 200, 350, 390})
            QTest::addRow("noise %g, at %d", noise, position) << noise << position;
    }
}

void TestStartDetection::detect_spikesBeforeStep_areIgnored()
{
    QFETCH(double, noise);
    QFETCH(int, position);
    Eigen::VectorXd values = smallRecord(noise);
    values[position] += 20.0;
    values[position / 2] -= 20.0;
    compareStart(detectStart(doubleChannel(values, 1e6)), 400, 406);
}

void TestStartDetection::detect_driftingBaseline_findsStep()
{
    for (const double drift : {-0.02, 0.02, 0.1}) { // of the step per ms; 0.4 ms before the step
        Eigen::VectorXd values = smallRecord(0.005);
        values += Eigen::VectorXd::LinSpaced(4000, 0.0, 4.0 * drift);
        const auto start = detectStart(doubleChannel(values, 1e6));
        compareStart(start, 398, 408);
        QVERIFY(start->baselineAtRest);
    }
}

void TestStartDetection::detect_strongDrift_isNotAtRest()
{
    Eigen::VectorXd values = smallRecord(0.005);
    values += Eigen::VectorXd::LinSpaced(4000, 0.0, 20.0); // twice the step before it happens
    const auto start = detectStart(doubleChannel(values, 1e6));
    QVERIFY(!start || !start->baselineAtRest);
}

void TestStartDetection::detect_invalidSamples_areSkipped()
{
    Eigen::VectorXd values = smallRecord(0.005);
    values.segment(150, 60).setConstant(kNan);
    values[399] = std::numeric_limits<double>::infinity();
    values[1000] = -std::numeric_limits<double>::infinity();
    compareStart(detectStart(doubleChannel(values, 1e6)), 400, 404);
    values.head(390).setConstant(kNan);
    compareNoStart(detectStart(doubleChannel(values, 1e6)), "quiet samples");
    values.setConstant(kNan);
    compareNoStart(detectStart(doubleChannel(values, 1e6)), "no valid samples");
}

void TestStartDetection::detect_stepAtTheVeryEnd_staysInside()
{
    // the mean that must cross in noise would reach beyond the record
    for (Index behind = 1; behind <= 60; ++behind) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Eigen::VectorXd values = Gaussian(seed).vector(300, 0.2);
            values.tail(behind).array() += 1.0;
            const auto start = detectStart(doubleChannel(values, 1e6));
            QVERIFY(!start || start->sample < 300);
        }
    }
}

void TestStartDetection::detect_twoSteps_findsTheFirst()
{
    // a side wall: incident shock, then the reflected one, twice as high
    StepRecord incident = shockRecord(300e3, 0.1, 0.005),
               reflected = shockRecord(300e3, 0.1, 0.005);
    reflected.arrival_s += 0.002;
    reflected.step = 2.2;
    reflected.seed = 9;
    const Eigen::VectorXd values = incident.values() + reflected.values();
    compareStart(detectStart(doubleChannel(values, 100e6)), 200000, 200040);
}

void TestStartDetection::detect_plateauThatEnds_findsTheStep()
{
    StepRecord record = shockRecord(300e3, 0.1, 0.005);
    Eigen::VectorXd values = record.values();
    for (Index i = 360000; i < values.size(); ++i)
        values[i] -= 1.2 * (1.0 - std::exp(-static_cast<double>(i - 360000) / 50000.0));
    compareStart(detectStart(doubleChannel(values, 100e6)), 200000, 200040);
}

void TestStartDetection::detect_decay_findsItsBegin()
{
    const SecondOrder plate{804.0, 0.01};
    for (const double noise : {0.0, 0.001, 0.02}) {
        Eigen::VectorXd values = Gaussian(4).vector(5500, noise);
        for (Index i = 500; i < values.size(); ++i)
            values[i] += plate.decay(static_cast<double>(i - 499) / 50e3);
        compareStart(detectStart(doubleChannel(values, 50e3)), 499, 502);
    }
}

void TestStartDetection::detect_noStep_isBlocked_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("empty") << 0;
    QTest::newRow("63 samples") << 1;
    QTest::newRow("constant") << 2;
    QTest::newRow("noise") << 3;
    QTest::newRow("ramp") << 4;
    QTest::newRow("one spike in noise") << 5;
}

void TestStartDetection::detect_noStep_isBlocked()
{
    QFETCH(int, kind);
    const std::array<Eigen::VectorXd, 6> records{Eigen::VectorXd(), Gaussian(1).vector(63, 1.0),
        Eigen::VectorXd::Constant(5000, 3.0), Gaussian(2).vector(300'000, 1.0),
        Eigen::VectorXd::LinSpaced(5000, 0.0, 1.0) + Gaussian(3).vector(5000, 1e-3),
        Gaussian(5).vector(5000, 1.0) + 100.0 * Eigen::VectorXd::Unit(5000, 2500)};
    compareNoStart(
        detectStart(doubleChannel(records[static_cast<std::size_t>(kind)], 1e6)), "window.start");
    if (kind != 3)
        return;
    for (std::uint64_t seed = 10; seed < 60; ++seed)
        compareNoStart(
            detectStart(doubleChannel(Gaussian(seed).vector(5000, 1.0), 1e6)), "no step");
}

void TestStartDetection::detect_noStep_saysWhatDecides_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("why");
    QTest::newRow("noise") << 0 << "6 times the noise of";
    QTest::newRow("ramp") << 1 << "2 times the";
}

/// The sentence must be true of its own numbers: the change is below what is needed, and what is
/// needed is what it says it is.
void TestStartDetection::detect_noStep_saysWhatDecides()
{
    QFETCH(int, kind);
    QFETCH(QString, why);
    const std::array<Eigen::VectorXd, 2> records{Gaussian(2).vector(300'000, 1.0),
        Eigen::VectorXd::LinSpaced(5000, 0.0, 1.0) + Gaussian(3).vector(5000, 1e-3)};
    const auto start = detectStart(doubleChannel(records[static_cast<std::size_t>(kind)], 1e6));
    QVERIFY(!start);
    const Message &message = start.error().message;
    QVERIFY2(QString::fromStdString(english(message)).contains(why), english(message).c_str());
    const auto volts = [&](std::size_t argument) {
        const QStringList words = QString::fromStdString(message.arguments[argument]).split(' ');
        return words[0].toDouble() * (words.value(1).startsWith('m') ? 1e-3 : 1.0);
    };
    QVERIFY2(volts(2) <= volts(3), english(message).c_str());
    QVERIFY(std::abs(volts(4) * volts(5) / volts(3) - 1.0) < 0.02); // three digits each
}

void TestStartDetection::detect_startAtFirstSamples_isBlocked_data()
{
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("zeta");
    QTest::addColumn<bool>("isStep");
    QTest::addColumn<int>("lead");
    for (const double f0_Hz : {30e3, 100e3, 318e3}) {
        for (const double zeta : {0.005, 0.02, 0.2}) {
            for (const bool isStep : {true, false}) {
                for (const int lead : {0, 1, 20})
                    QTest::addRow(
                        "%g Hz, %g, %s, lead %d", f0_Hz, zeta, isStep ? "step" : "decay", lead)
                        << f0_Hz << zeta << isStep << lead;
            }
        }
    }
}

void TestStartDetection::detect_startAtFirstSamples_isBlocked()
{
    QFETCH(double, f0_Hz);
    QFETCH(double, zeta);
    QFETCH(bool, isStep);
    QFETCH(int, lead);
    const SecondOrder sensor{f0_Hz, zeta};
    const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(400, [&](Index i) {
        const double t_s = static_cast<double>(i - lead) * 1e-6;
        return isStep ? sensor.step(t_s) : sensor.decay(t_s);
    });
    compareNoStart(detectStart(doubleChannel(values, 1e6)), "window.start");
}

void TestStartDetection::detect_shotNumber_isNamed()
{
    const auto start = detectStart(doubleChannel(Eigen::VectorXd::Zero(500), 1e6), {}, 3);
    QVERIFY(!start);
    QCOMPARE(start.error().shot, Index(3));
    QVERIFY(english(start.error().message).starts_with("Shot 3, channel DUT: "));
}

void TestStartDetection::detect_stopRequested_isCancelled()
{
    std::stop_source source;
    source.request_stop();
    const auto start = detectStart(doubleChannel(smallRecord(), 1e6), {source.get_token(), {}});
    QVERIFY(!start);
    QCOMPARE(start.error().kind, ErrorKind::Cancelled);
}

void TestStartDetection::detect_timeAxis_usesRecordOrigin()
{
    const Channel channel = doubleChannel(smallRecord(), 1e6, -0.5);
    const auto start = detectStart(channel);
    QVERIFY(start.has_value());
    QCOMPARE(start->time_s, -0.5 + static_cast<double>(start->sample) * 1e-6);
}

void TestStartDetection::detect_impactRecords_startBeforeTheirPeak()
{
    const auto folder
        = dataFolder() / "highrate_ds5_impact/data/dataset-1/data-1/PCB_repeated_shock_trials";
    int covered = 0;
    for (int n = 0; n <= 50; n += 5) {
        const auto values = textColumn(folder / ("acc_pcb_a" + std::to_string(n) + ".txt"), 1);
        if (!values)
            continue;
        ++covered;
        const auto start = detectStart(doubleChannel(*values, 50e3));
        compareStart(start, 380, 460); // moves from 380 on, hits at 455, peak at 470..500
        QVERIFY(start->baselineAtRest);
    }
    qInfo("%d of 11 impact records covered", covered);
    if (covered == 0)
        DYNCAL_SKIP_WITHOUT_DATA("Measured data are missing: set DYNCAL_DATA");
}

void TestStartDetection::detect_labviewRecords_startBeforeTheirPeak_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("column");
    QTest::addColumn<int>("peak"); ///< expected/ds5_lvm.json
    QTest::addColumn<bool>("atRest");
    QTest::newRow("001, 0") << "Test_001.lvm" << 1 << 4741 << true;
    QTest::newRow("001, 1") << "Test_001.lvm" << 2 << 4763 << true;
    QTest::newRow("002, 0") << "Test_002.lvm" << 1 << 5006 << true;
    QTest::newRow("004, 0") << "Test_004.lvm" << 1 << 5687 << true;
    QTest::newRow("017, 0 at the rail") << "Test_017.lvm" << 1 << 4193 << false;
    QTest::newRow("017, 1 at the rail") << "Test_017.lvm" << 2 << 4196 << false;
}

void TestStartDetection::detect_labviewRecords_startBeforeTheirPeak()
{
    QFETCH(QString, name);
    QFETCH(int, column);
    QFETCH(int, peak);
    QFETCH(bool, atRest);
    const auto file
        = dataFolder() / "highrate_ds5_impact/data/dataset-2/data-1" / name.toStdString();
    const auto values = textColumn(file, static_cast<std::size_t>(column), "***End_of_Header***");
    if (!values)
        DYNCAL_SKIP_WITHOUT_DATA("Measured data are missing: set DYNCAL_DATA");
    const auto start = detectStart(doubleChannel(*values, 51200.0));
    compareStart(start, peak - 60, peak);
    QCOMPARE(start->baselineAtRest, atRest);
}

void TestStartDetection::detect_syntheticSeriesWithoutLead_isBlocked()
{
    int covered = 0;
    for (const char *name : {"step2", "imp2", "step3", "piezo318k"}) {
        const auto values
            = textColumn(dataFolder() / "synthetic" / ("syn_" + std::string(name) + ".csv"), 0);
        if (!values)
            continue;
        ++covered;
        compareNoStart(detectStart(doubleChannel(*values, 1e6)), "window.start");
    }
    qInfo("%d of 4 synthetic series covered", covered);
    if (covered == 0)
        DYNCAL_SKIP_WITHOUT_DATA("Synthetic series are missing: set DYNCAL_DATA");
}

void TestStartDetection::crossing_ramp_isExact()
{
    const Channel channel = doubleChannel(Eigen::VectorXd::LinSpaced(101, 0.0, 100.0), 10.0, 2.0);
    QCOMPARE(crossingTime_s(channel, 25.25, 0), std::optional<double>(2.0 + 2.525));
    QCOMPARE(crossingTime_s(channel, 25.0, 0), std::optional<double>(2.0 + 2.5));
    QCOMPARE(crossingTime_s(channel, 0.0, 0), std::optional<double>(2.0));
    const Channel falling = doubleChannel(Eigen::VectorXd::LinSpaced(101, 100.0, 0.0), 10.0);
    QCOMPARE(crossingTime_s(falling, 99.5, 0), std::optional<double>(0.05));
    QCOMPARE(crossingTime_s(falling, 99.5, 1), std::optional<double>());
}

void TestStartDetection::crossing_noneOrInvalid_isEmpty()
{
    const Channel ramp = doubleChannel(Eigen::VectorXd::LinSpaced(11, 0.0, 10.0), 1.0);
    QVERIFY(!crossingTime_s(ramp, 10.5, 0));
    QVERIFY(!crossingTime_s(ramp, 2.5, 3));
    QVERIFY(!crossingTime_s(ramp, 2.5, 11));
    QCOMPARE(crossingTime_s(ramp, 2.5, -5), std::optional<double>(2.5));
    QVERIFY(!crossingTime_s(doubleChannel(Eigen::VectorXd(), 1.0), 1.0, 0));
    QVERIFY(!crossingTime_s(doubleChannel(Eigen::Vector3d(0.0, kNan, 5.0), 1.0), 2.0, 0));
}

void TestStartDetection::crossing_acrossChunks_isFound()
{
    for (const Index at : {8190, 8191, 8192, 8193, 16382, 20000}) {
        Eigen::VectorXd values = Eigen::VectorXd::Zero(20001);
        values.tail(20001 - at).setOnes();
        const auto time = crossingTime_s(doubleChannel(values, 1.0), 0.5, 0);
        QCOMPARE(time, std::optional<double>(static_cast<double>(at) - 0.5));
    }
}

DYNCAL_TEST(TestStartDetection)
#include "tst_start_detection.moc"
