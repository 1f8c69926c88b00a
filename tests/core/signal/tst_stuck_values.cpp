// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/capture_open.h"
#include "core/signal/response_window.h"
#include "core/signal/stuck_values.h"
#include "core/signal/window_cutting.h"
#include "tests/support/measured_data.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

Eigen::VectorXd rounded(const Eigen::VectorXd &values, double code)
{
    return code > 0.0 ? Eigen::VectorXd(code * (values / code).array().round()) : values;
}

/// Noise whose neighbours are alike: white noise through a running mean.
Eigen::VectorXd noise(Gaussian &random, Index size, double sd, Index width)
{
    const Eigen::VectorXd white = random.vector(size + width, sd * std::sqrt(double(width)));
    return Eigen::VectorXd::NullaryExpr(
        size, [&](Index i) { return white.segment(i, width).mean(); });
}

/// A step of 2.5 at sample 4000 of 40 000, as a converter with this code and no known limits has
/// it; from `stuckFrom` on it stands still.
Channel record(double noiseSd, double code, Index stuckFrom, std::uint64_t seed = 1)
{
    StepRecord step;
    step.sensor = {300e3, 0.1};
    step.baseline = 0.2;
    step.step = 2.5;
    step.noiseSd = noiseSd;
    step.seed = seed;
    Eigen::VectorXd values = rounded(step.values(), code);
    if (stuckFrom < values.size())
        values.tail(values.size() - stuckFrom).setConstant(values[stuckFrom]);
    return doubleChannel(values, step.rate_Hz);
}

Result<WindowResult> cut(const Channel &channel)
{
    return cutWindows(captureSetOf({channel}), {}, {});
}

/// Whether a caution says that the record stands still.
bool isNamed(const WindowResult &result)
{
    return std::ranges::any_of(result.findings, [](const Finding &finding) {
        return finding.id == "CAP-007" && finding.severity == Severity::Caution;
    });
}

} // namespace

/// Records that stand still for more of the window than the noise of their baseline explains.
class TestStuckValues : public QObject
{
    Q_OBJECT

private slots:
    void stuckRecord_isBlocked_data()
    {
        QTest::addColumn<double>("code");
        for (const double code : {0.0, 1e-4, 1e-3, 0.0025, 0.005})
            QTest::addRow("code of %g V", code) << code;
    }

    void stuckRecord_isBlocked()
    {
        QFETCH(double, code);
        const auto stuck = cut(record(0.0025, code, 5000)); // 3.5 of 3.6 ms
        QVERIFY(!stuck);
        QCOMPARE(stuck.error().findingId, std::string("CAP-007"));
        QCOMPARE(stuck.error().kind, ErrorKind::DataBlocked);
        const std::string sentence = english(stuck.error().message);
        QVERIFY2(
            sentence.find("97 % of the response window") != std::string::npos, sentence.c_str());
        // A sample or two before may be equal by chance.
        QVERIFY2(sentence.find("from 500 \xC2\xB5s on") != std::string::npos
                || sentence.find("from 499.") != std::string::npos,
            sentence.c_str());
        QVERIFY(!cut(record(0.0025, code, 32000))); // 22 %
        QVERIFY(cut(record(0.0025, code, 33000))); // 19 %
        QVERIFY(cut(record(0.0025, code, 40000)));
    }

    /// A record that freezes while it rings: the search for the plateau's end finds the freeze.
    void frozenRinging_givesNoWrongStepWithoutAWord()
    {
        Gaussian random(11);
        const int trials = trials::count(100, 2000);
        int blocked = 0, named = 0;
        for (int k = 0; k < trials; ++k) {
            StepRecord step;
            step.sensor = {200e3 * std::pow(0.1, random.uniform()), 0.01 + 0.05 * random.uniform()};
            step.noiseSd = 0.002;
            step.seed = 100 + static_cast<std::uint64_t>(k);
            Eigen::VectorXd values = step.values();
            const auto frozen = 4300 + static_cast<Index>(20000.0 * std::pow(random.uniform(), 3));
            values.tail(values.size() - frozen).setConstant(values[frozen]);
            const auto done = cut(doubleChannel(values, step.rate_Hz));
            blocked += done ? 0 : 1;
            named += done && isNamed(*done) ? 1 : 0;
            QVERIFY2(!done || isNamed(*done)
                    || std::abs(done->responses[0].step - step.step) < 0.005 * step.step,
                qPrintable(QString("trial %1, frozen at %2").arg(k).arg(frozen)));
        }
        qInfo("%d trials: %d blocked, %d named", trials, blocked, named);
        QVERIFY(2 * blocked > trials);
    }

    void frozenBehindATypedEnd_isACaution()
    {
        WindowSettings settings;
        settings.end_s.value = 5e-4;
        const Channel channel = record(0.0025, 1e-3, 9600); // 60 us behind the end
        const auto done = cutWindows(captureSetOf({channel}), settings, {});
        QVERIFY(done && isNamed(*done));
        QVERIFY(std::abs(done->responses[0].step - 2.5) < 0.01);
        QVERIFY(!isNamed(*cutWindows(captureSetOf({record(0.0025, 1e-3, 40000)}), settings, {})));
    }

    void clippedRinging_countsAllItsTops()
    {
        StepRecord step;
        step.sensor = {20e3, 0.002};
        step.noiseSd = 0.001;
        const auto clipped = [&](double limit) {
            return cut(doubleChannel(step.values().cwiseMin(limit), step.rate_Hz));
        };
        QCOMPARE(clipped(1.2).error().findingId, std::string("CAP-007"));
        QVERIFY(clipped(1.95)); // a caution, as before
        QVERIFY(clipped(3.0));
    }

    void computedRecord_isNeverBlocked_data()
    {
        QTest::addColumn<double>("code");
        QTest::addColumn<Index>("stuckFrom");
        for (const double code : {0.0, 1e-3, 0.1}) {
            QTest::addRow("code of %g V, settles", code) << code << Index(40000);
            QTest::addRow("code of %g V, constant from 5000 on", code) << code << Index(5000);
        }
    }

    void computedRecord_isNeverBlocked()
    {
        QFETCH(double, code);
        QFETCH(Index, stuckFrom);
        QVERIFY(cut(record(0.0, code, stuckFrom)));
        QVERIFY(cut(record(1e-16, code, stuckFrom))); // rounding of the arithmetic
    }

    void noise_explainsItsOwnRuns_data()
    {
        QTest::addColumn<Index>("width");
        for (const Index width : {1, 3, 10, 40})
            QTest::addRow("correlated over %lld", static_cast<long long>(width)) << width;
    }

    /// However the level lies in its code, baseline here and plateau there, codes from a tenth to
    /// thirty times the noise.
    void noise_explainsItsOwnRuns()
    {
        QFETCH(Index, width);
        Gaussian random(static_cast<std::uint64_t>(width));
        const int trials = trials::count(400, 20000);
        int alarms = 0;
        for (int k = 0; k < trials; ++k) {
            const double code = std::pow(10.0, -1.0 + 2.5 * random.uniform());
            const auto baseline = static_cast<Index>(50.0 + 2000.0 * random.uniform());
            const auto size = static_cast<Index>(200.0 + 8000.0 * random.uniform());
            const Eigen::VectorXd all = noise(random, baseline + size, 1.0, width);
            const double low = code * random.uniform(), high = code * (40.0 + random.uniform());
            const auto stuck = stuckValues(rounded((all.tail(size).array() + high).matrix(), code),
                rounded((all.head(baseline).array() + low).matrix(), code));
            alarms += stuck && 5 * stuck->total > size ? 1 : 0;
        }
        qInfo("%d false alarms in %d trials", alarms, trials);
        QCOMPARE(alarms, 0);
    }

    void heldSamples_areNoFlatTop()
    {
        Gaussian random(5);
        for (const Index hold : {2, 8, 20}) { // each sample printed so often
            const Eigen::VectorXd values = random.vector(12000 / hold, 1.0);
            const Eigen::VectorXd held
                = Eigen::VectorXd::NullaryExpr(12000, [&](Index i) { return values[i / hold]; });
            QVERIFY(!stuckValues(held.tail(9000), held.head(3000)));
        }
    }

    void driftWithoutNoise_isNoNoise()
    {
        const Eigen::VectorXd drift = Eigen::VectorXd::LinSpaced(4000, 0.0, 7.3);
        for (const double code : {1.0, 0.1, 0.001})
            QVERIFY(!stuckValues(
                rounded(Eigen::VectorXd::Constant(3000, 50.0), code), rounded(drift, code)));
    }

    /// Every channel of every recording as if it were the sensor's.
    void measuredRecords_areNotStuck()
    {
        if (!std::filesystem::exists(dataFolder()))
            DYNCAL_SKIP_WITHOUT_DATA("the folder of recordings is missing (DYNCAL_DATA)");
        int files = 0, cutOut = 0;
        QStringList stuck;
        for (const auto &entry : std::filesystem::recursive_directory_iterator(dataFolder())) {
            if (!entry.is_regular_file())
                continue;
            const Result<CaptureSet> set = openCapture(entry.path().string(), {});
            if (!set)
                continue;
            ++files;
            for (const Shot &shot : set->shots) {
                for (Channel channel : shot.channels) {
                    channel.role = ChannelRole::Dut;
                    channel.sampleRate_Hz
                        = channel.sampleRate_Hz > 0.0 ? channel.sampleRate_Hz : 1e6;
                    channel.adcMin = channel.adcMax = std::nullopt;
                    const auto done = cut(channel);
                    cutOut += done ? 1 : 0;
                    if (!done && done.error().findingId == "CAP-007")
                        stuck << QString::fromStdString(entry.path().filename().string() + ": "
                            + english(done.error().message));
                }
            }
        }
        qInfo("%d files covered, %d windows cut", files, cutOut);
        QVERIFY2(stuck.isEmpty(), qPrintable(stuck.join('\n')));
    }

    void nothing_isNotStuck()
    {
        Gaussian random(6);
        QVERIFY(!stuckValues(Eigen::VectorXd(), random.vector(100, 1.0)));
        QVERIFY(!stuckValues(Eigen::VectorXd::Zero(100), Eigen::VectorXd()));
        QVERIFY(!stuckValues(Eigen::VectorXd::Zero(100), Eigen::VectorXd::Zero(100)));
        QVERIFY(stuckValues(Eigen::VectorXd::Zero(100), random.vector(100, 1.0)));
    }
};

DYNCAL_TEST(TestStuckValues)
#include "tst_stuck_values.moc"
