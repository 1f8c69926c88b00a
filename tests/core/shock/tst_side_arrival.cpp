// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/side_arrival.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kT0_s = -2e-4;
constexpr double kRounding = 1e-12;

/// A side wall's pressure: 1 before, a ramp from `begin_s` of `rise_s` to 3, from `reflected_s`
/// on 9.
struct SideRecord
{
    double begin_s = 1.003e-4;
    double rise_s = 20e-6;
    double reflected_s = 8e-4;
    double factor = 1.0;
    double noiseSd = 0.0;
    std::uint64_t seed = 1;

    Channel channel() const
    {
        testing::Gaussian noise(seed);
        Eigen::VectorXd values(2000);
        for (Index i = 0; i < values.size(); ++i) {
            const double t_s = kT0_s + static_cast<double>(i) / kRate_Hz;
            const double ramp = std::clamp((t_s - begin_s) / rise_s, 0.0, 1.0);
            values[i] = factor * (t_s >= reflected_s ? 9.0 : 1.0 + 2.0 * ramp) + noiseSd * noise();
        }
        return testing::doubleChannel(values, kRate_Hz, kT0_s);
    }

    DetectedStart start() const
    {
        DetectedStart found;
        found.sample = static_cast<Index>(std::ceil((begin_s - kT0_s) * kRate_Hz));
        found.time_s = kT0_s + static_cast<double>(found.sample) / kRate_Hz;
        found.baseline = factor;
        found.noiseSd = noiseSd;
        return found;
    }
};

} // namespace

class TestSideArrival : public QObject
{
    Q_OBJECT

private slots:
    void ramp_crossesHalfOfItsOwnStep()
    {
        for (const double factor : {1.0, -1.0, 1e-6}) {
            SideRecord record;
            record.factor = factor;
            const auto found = sideArrival(record.channel(), record.start(), record.reflected_s);
            QVERIFY(found.has_value());
            QVERIFY(std::abs(found->time_s - (record.begin_s + 10e-6)) < kRounding);
            QVERIFY(std::abs(found->rise_s - 16e-6) < kRounding); // 10 % to 90 %
            QVERIFY(std::abs(found->behind - 3.0 * factor) < kRounding);
            QCOMPARE(found->before, factor);
        }
    }

    void reflectedShock_doesNotEnterTheLevelBehind()
    {
        // From the reflection on it is nine: with the whole half millisecond it would be the
        // median.
        SideRecord record;
        record.reflected_s = record.begin_s + 1.6e-4;
        const auto found = sideArrival(record.channel(), record.start(), record.begin_s + 1.2e-4);
        QVERIFY(std::abs(found->behind - 3.0) < kRounding);
        QVERIFY(std::abs(found->time_s - (record.begin_s + 10e-6)) < kRounding);
        // Unknown, and one that is not behind the start: the half millisecond.
        for (const std::optional<double> until :
            {std::optional<double>(), std::optional(record.begin_s - 1e-4)}) {
            const auto other = sideArrival(record.channel(), record.start(), until);
            QVERIFY(std::abs(other->behind - 9.0) < kRounding);
        }
    }

    void uncertainty_isNoiseOverSlope()
    {
        // 0.04 of noise over a slope of 2 in 20 us, the 50 % crossing of 200 records.
        constexpr int kRuns = 200;
        double squares = 0.0;
        double stated = 0.0;
        for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
            SideRecord record;
            record.noiseSd = 0.01;
            record.seed = seed;
            const auto found = sideArrival(record.channel(), record.start(), record.reflected_s);
            squares += std::pow(found->time_s - (record.begin_s + 10e-6), 2) / kRuns;
            stated += found->u_time_s / kRuns;
        }
        const double slope = 2.0 / 20e-6;
        QVERIFY2(
            std::abs(stated / (0.01 / slope) - 1.0) < 0.15, qPrintable(QString::number(stated)));
        // The crossing lies 0.3 of a sample behind one: two noises, weighted 0.7 and 0.3. The
        // scatter of 200 is known to 5 %.
        const double ratio = std::sqrt(squares) / (std::hypot(0.7, 0.3) * 0.01 / slope);
        QVERIFY2(std::abs(ratio - 1.0) < 0.15, qPrintable(QString::number(ratio)));
    }

    void noNoise_theSpacingIsWhatIsUnknown_data()
    {
        QTest::addColumn<double>("rise"); // samples
        for (const double rise : {1e-3, 0.5, 1.0, 1.5, 2.0, 3.0, 10.0})
            QTest::addRow("rise of %g samples", rise) << rise;
    }
    void noNoise_theSpacingIsWhatIsUnknown()
    {
        // Wherever between two samples the front lies, its error must be what is stated.
        QFETCH(double, rise);
        constexpr int kPlaces = 100;
        double errors = 0.0;
        double stated = 0.0;
        for (int i = 0; i < kPlaces; ++i) {
            SideRecord record;
            record.rise_s = rise / kRate_Hz;
            record.begin_s = 1e-4 + (i + 0.5) / kPlaces / kRate_Hz;
            const auto found = sideArrival(record.channel(), record.start(), record.reflected_s);
            const double error_s = found->time_s - record.begin_s - 0.5 * record.rise_s;
            errors += std::pow(error_s * kRate_Hz, 2) / kPlaces;
            stated += std::pow(found->u_time_s * kRate_Hz, 2) / kPlaces;
        }
        QVERIFY2(errors < 1.01 * stated,
            qPrintable(QString("%1, stated %2").arg(std::sqrt(errors)).arg(std::sqrt(stated))));
        QVERIFY(std::sqrt(stated) < (rise < 2.5 ? 0.31 : 0.011)); // 1/sqrt(12), a hundredth
    }

    void invalidSamples_areNoLevel()
    {
        SideRecord record;
        Channel channel = record.channel();
        const Eigen::VectorXd values = physicalValues(channel, 0, channel.samples.size());
        std::vector<double> spoilt(values.begin(), values.end());
        for (std::size_t i = 400; i < 800; i += 2)
            spoilt[i] = std::numeric_limits<double>::quiet_NaN();
        channel.samples = RawSamples(spoilt);
        const auto found = sideArrival(channel, record.start(), record.reflected_s);
        QVERIFY(found && std::abs(found->behind - 3.0) < kRounding);
        for (double &value : spoilt)
            value = std::numeric_limits<double>::quiet_NaN();
        channel.samples = RawSamples(spoilt);
        QVERIFY(!sideArrival(channel, record.start(), record.reflected_s));
    }

    void startAtTheEndOfTheRecord_isNoArrival()
    {
        SideRecord record;
        const Channel channel = record.channel();
        DetectedStart start = record.start();
        start.sample = channel.samples.size();
        QVERIFY(!sideArrival(channel, start, {}));
        QVERIFY(!sideArrival(testing::doubleChannel(Eigen::VectorXd(0), kRate_Hz), {}, {}));
    }

    void reflectedShock_crossesHalfOfItsOwnStep()
    {
        // p1 1, p2 3, p5 9: the front of the reflected shock is one sample, from 3 to 9.
        for (const double factor : {1.0, -1.0, 1e-6}) {
            SideRecord record;
            record.factor = factor;
            record.reflected_s = 7e-4;
            const double wall_s = 4e-4;
            const Channel channel = record.channel();
            auto found = sideArrival(channel, record.start(), wall_s);
            const auto back = returnPassage(channel, *found, wall_s);
            QVERIFY(back.has_value());
            QVERIFY(std::abs(back->time_s - (record.reflected_s - 0.5 / kRate_Hz)) < kRounding);
            QVERIFY(back->u_time_s > 0.28 / kRate_Hz && back->u_time_s < 0.5 / kRate_Hz);
            QVERIFY(std::isnan(back->level)); // not read yet
            QVERIFY(std::abs(levelBehindReturn(channel, *back, wall_s, 1.0) - 9.0 * factor)
                < kRounding);
            // Its plateau ends before the level can be read.
            QVERIFY(std::isnan(levelBehindReturn(channel, *back, wall_s, record.reflected_s)));
        }
    }

    void noReflectedShock_noReturn()
    {
        SideRecord record;
        record.reflected_s = 1.0; // behind the record
        const auto found = sideArrival(record.channel(), record.start(), 4e-4);
        QVERIFY(!returnPassage(record.channel(), *found, 4e-4));
        QVERIFY(!returnPassage(record.channel(), *found, 1.0));
    }

    void noise_hidesTheReturn_ratherThanMakesOne()
    {
        SideRecord record;
        record.noiseSd = 0.3; // a step of 2: below ten of the noise
        record.reflected_s = 7e-4;
        const auto found = sideArrival(record.channel(), record.start(), 4e-4);
        QVERIFY(found && !returnPassage(record.channel(), *found, 4e-4));
        record.noiseSd = 0.05;
        const auto clear = sideArrival(record.channel(), record.start(), 4e-4);
        QVERIFY(returnPassage(record.channel(), *clear, 4e-4).has_value());
    }

    void medianBetween_ofTheTimesAsked()
    {
        Eigen::VectorXd values(101);
        for (Index i = 0; i < values.size(); ++i)
            values[i] = static_cast<double>(i);
        values[40] = 1e9;
        values[50] = std::numeric_limits<double>::quiet_NaN();
        const Channel channel = testing::doubleChannel(values, kRate_Hz, kT0_s);
        const auto at = [](double sample) { return kT0_s + sample / kRate_Hz; };
        // [10, 21): 10 .. 20
        QCOMPARE(medianBetween(channel, at(10.01), at(21.01)), std::optional(15.0));
        // 39, 1e9, 41: a spike does not count; nor does what is no number.
        QCOMPARE(medianBetween(channel, at(39.01), at(42.01)), std::optional(41.0));
        QCOMPARE(medianBetween(channel, at(50.01), at(51.01)), std::optional<double>());
        QCOMPARE(medianBetween(channel, at(49.01), at(51.01)), std::optional(49.0));
        // Cut to the record, empty beside it.
        QCOMPARE(medianBetween(channel, -1.0, at(3.01)), std::optional(1.0));
        QCOMPARE(medianBetween(channel, at(98.01), 1.0), std::optional(99.0));
        QVERIFY(!medianBetween(channel, 1.0, 2.0));
        QVERIFY(!medianBetween(channel, at(20.0), at(10.0)));
    }
};

DYNCAL_TEST(TestSideArrival)
#include "tst_side_arrival.moc"
