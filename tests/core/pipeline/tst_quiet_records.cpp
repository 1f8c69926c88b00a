// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Records without noise, or with less than their rounding: what whoever checks the program against
// theory tries first. Order, poles and findings must be those of the truth.

#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_table.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/quiet_captures.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <algorithm>
#include <array>

using namespace dyncal;

namespace {

/// Error over stated standard uncertainty: rounding errors are bounded, so that more than four does
/// not come by chance.
constexpr double kLargest_z = 4.0;
/// Beyond any uncertainty: rounding of double precision, over conditions of up to a thousand.
constexpr double kArithmetic = 1e-11;

SensorSpec sensorOf(std::vector<SensorMode> modes, std::optional<double> realPole_Hz = {})
{
    return {"closed form", 1.0, std::move(modes), realPole_Hz, {}};
}

/// What noise-free data must not be said to have.
QString untrueFinding(const Findings &findings)
{
    constexpr std::array kUntrue{"RSP-001", "MOD-004", "MOD-007", "MOD-008", "MOD-009", "MOD-010",
        "ORD-001", "ORD-003", "CAP-007"};
    for (const Finding &finding : findings) {
        if (finding.severity == Severity::Block
            || std::any_of(
                kUntrue.begin(), kUntrue.end(), [&](const char *id) { return finding.id == id; }))
            return QString::fromStdString(finding.id + ": " + english(finding.message));
    }
    return {};
}

QString compare(double found, double u, double truth, const char *what)
{
    const double error = std::abs(found - truth);
    if (u > 0.0 && error < kLargest_z * u + kArithmetic * truth)
        return {};
    return QString("%1: found %2, u %3, true %4")
        .arg(what)
        .arg(found, 0, 'g', 15)
        .arg(u)
        .arg(truth);
}

/// Empty if order, poles and findings are true; else what is wrong.
QString fault(const SensorSpec &sensor, std::shared_ptr<const CaptureSet> captures)
{
    ResultCache cache;
    const PipelineOutcome outcome = runPipeline(std::move(captures), {}, cache, StageId::Evidence);
    const CalibrationResults &r = outcome.results;
    if (outcome.error)
        return QString::fromStdString(english(outcome.error->message));
    const auto order = static_cast<Index>(2 * sensor.modes.size() + (sensor.realPole_Hz ? 1 : 0));
    if (r.decomposition->suggestion.order != order)
        return QString("order %1 instead of %2").arg(r.decomposition->suggestion.order).arg(order);
    if (r.model->diverges || !r.model->refined)
        return "diverges, or is not refined";
    const std::vector<Pole> &poles = polesOf(*r.model, r.assessment.get());
    for (const SensorMode &mode : sensor.modes) {
        const auto distance = [&](const Pole &pole) {
            return pole.s_rad_s.imag() > 0.0 ? std::abs(pole.frequency_Hz - mode.f0_Hz) : 1e300;
        };
        const auto pole = std::min_element(poles.begin(), poles.end(),
            [&](const Pole &a, const Pole &b) { return distance(a) < distance(b); });
        QString wrong = compare(pole->frequency_Hz, pole->u_frequency_Hz, mode.f0_Hz, "f0");
        if (wrong.isEmpty())
            wrong = compare(pole->dampingRatio, pole->u_dampingRatio, mode.zeta, "zeta");
        if (!wrong.isEmpty())
            return wrong;
    }
    return untrueFinding(allFindings(r));
}

QString faultOfPreset(const SensorSpec &sensor, double noise, int bits, std::uint64_t seed)
{
    SimulationSettings settings;
    settings.sensor = sensor;
    settings.noise = noise;
    settings.bits = bits;
    settings.seed = seed;
    settings.duration_s = 0.004;
    return fault(sensor, std::make_shared<const CaptureSet>(simulateShots(settings)->set));
}

} // namespace

class TestQuietRecords : public QObject
{
    Q_OBJECT

private slots:
    void presets_withoutNoise_data()
    {
        QTest::addColumn<int>("preset");
        QTest::addColumn<double>("noise");
        QTest::addColumn<int>("bits");
        for (int i = 0; i < 5; ++i) {
            const char *name = sensorPresets()[static_cast<std::size_t>(i)].name.c_str();
            for (const int bits : {14, 28})
                QTest::addRow("%s, %d bits", name, bits) << i << 0.0 << bits;
            QTest::addRow("%s, 14 bits, noise 1e-6", name) << i << 1e-6 << 14;
            QTest::addRow("%s, 14 bits, noise 1e-5", name) << i << 1e-5 << 14;
            QTest::addRow("%s, 28 bits, noise 1e-6", name) << i << 1e-6 << 28;
        }
    }
    void presets_withoutNoise()
    {
        QFETCH(int, preset);
        QFETCH(double, noise);
        QFETCH(int, bits);
        for (std::uint64_t seed = 1; seed <= std::uint64_t(trials::count(1, 2)); ++seed) {
            const QString wrong = faultOfPreset(
                sensorPresets()[static_cast<std::size_t>(preset)], noise, bits, seed);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        }
    }

    void closedForms_data()
    {
        QTest::addColumn<int>("sensor");
        QTest::addColumn<double>("resolution");
        const std::array names{"one mode", "one mode near the Nyquist frequency",
            "one well damped mode", "a mode and a real pole", "two modes", "a weak second mode",
            "three modes"};
        for (int i = 0; i < std::ssize(names); ++i) {
            for (const double resolution : {0.0, 1e-9, 1e-6, 1.0 / 8192.0})
                QTest::addRow("%s, to %g", names[static_cast<std::size_t>(i)], resolution)
                    << i << resolution;
        }
    }
    void closedForms()
    {
        QFETCH(int, sensor);
        QFETCH(double, resolution);
        const std::array sensors{sensorOf({{30e3, 0.05, 1.0}}), sensorOf({{300e3, 0.02, 1.0}}),
            sensorOf({{30e3, 0.5, 1.0}}), sensorOf({{300e3, 0.02, 1.0}}, 50e3),
            sensorOf({{30e3, 0.05, 0.9}, {60e3, 0.02, 0.1}}),
            sensorOf({{30e3, 0.05, 0.99}, {60e3, 0.02, 0.01}}),
            sensorOf({{30e3, 0.05, 0.7}, {50e3, 0.03, 0.2}, {75e3, 0.02, 0.1}})};
        testing::QuietRecord record;
        record.resolution = resolution;
        // In the suite the two rates take turns with the sensors.
        std::vector<double> rates_Hz{1e6, 10e6};
        if (trials::count(1, 2) == 1)
            rates_Hz = {rates_Hz[static_cast<std::size_t>(sensor % 2)]};
        for (const double rate_Hz : rates_Hz) {
            record.sampleRate_Hz = rate_Hz;
            record.after = rate_Hz > 5e6 ? 20000 : 5000;
            for (const std::vector<double> &steps :
                {std::vector<double>{0.6}, std::vector<double>{0.3, 0.6, 0.9}}) {
                record.steps = steps;
                const SensorSpec &spec = sensors[static_cast<std::size_t>(sensor)];
                const QString wrong = fault(spec, testing::quietCapture(spec, record));
                QVERIFY2(wrong.isEmpty(),
                    qPrintable(
                        QString("%1 Hz, %2 shots: %3").arg(rate_Hz).arg(steps.size()).arg(wrong)));
            }
        }
    }

    void offsetOfTheRecord_changesNothing()
    {
        testing::QuietRecord record;
        record.offset = 0.123456789;
        const SensorSpec sensor = sensorOf({{300e3, 0.02, 1.0}});
        const QString wrong = fault(sensor, testing::quietCapture(sensor, record));
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }

    void shotsThatDiffer_areStillToldApart()
    {
        // One shot of three 0.1 % off in frequency: 1000 times what rounding to 14 bits makes.
        testing::QuietRecord record;
        record.resolution = 1.0 / 8192.0;
        const auto same = testing::quietCapture(sensorOf({{300e3, 0.02, 1.0}}), record);
        const auto other = testing::quietCapture(sensorOf({{300.3e3, 0.02, 1.0}}), record);
        auto mixed = std::make_shared<CaptureSet>(*same);
        mixed->shots[1] = other->shots[1];
        ResultCache cache;
        const auto results = runPipeline(mixed, {}, cache, StageId::Evidence).results;
        QVERIFY(results.assessment && results.assessment->homogeneity);
        QVERIFY(!results.assessment->homogeneity->passed);
    }

    void modeBelowTheRounding_isNotInvented()
    {
        // A second mode of a tenth of a step is no more than rounding may make.
        testing::QuietRecord record;
        record.resolution = 1.0 / 8192.0;
        record.steps = {0.6};
        const auto captures = testing::quietCapture(
            sensorOf({{30e3, 0.05, 1.0 - 2e-5}, {60e3, 0.02, 2e-5}}), record);
        ResultCache cache;
        const auto results = runPipeline(captures, {}, cache, StageId::Evidence).results;
        QCOMPARE(results.decomposition->suggestion.order, Index(2));
    }
};

DYNCAL_TEST(TestQuietRecords)
#include "tst_quiet_records.moc"
