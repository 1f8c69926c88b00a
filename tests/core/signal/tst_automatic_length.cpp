// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/automatic_length.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace dyncal;

namespace {

constexpr Index kSamples = 50000;
constexpr Index kLong = 800'000;
constexpr double kNoise = 0.003;

struct Mode
{
    double period; ///< samples
    double zeta;
    double share; ///< of the step
};

/// 1 - sum of the modes' ringing, from sample 0 on, plus `later`, with white noise.
Eigen::VectorXd response(
    const std::vector<Mode> &modes,
    const std::function<double(double)> &later = [](double) { return 0.0; }, unsigned seed = 1,
    Index samples = kSamples)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, kNoise);
    Eigen::VectorXd values(samples);
    for (Index i = 0; i < samples; ++i) {
        const double t = static_cast<double>(i) + 0.5;
        values[i] = 1.0 + later(t) + noise(random);
        for (const Mode &mode : modes) {
            const double turn = 2.0 * std::numbers::pi * t / mode.period;
            values[i] -= mode.share * std::exp(-mode.zeta * turn) * std::cos(turn);
        }
    }
    return values;
}

Index lengthOf(const Eigen::VectorXd &values)
{
    return automaticStepLength(testing::doubleChannel(values, 1e6), 0, values.size(), 0.0, kNoise);
}

/// Down to 0.4 from there on, as a wave from the driver makes it.
std::function<double(double)> fallAt(double begin, double time)
{
    return [=](double t) { return t < begin ? 0.0 : -0.6 * (1.0 - std::exp(-(t - begin) / time)); };
}

/// Means as automaticStepLength() makes them of that record.
Eigen::VectorXd levels(const Eigen::VectorXd &values)
{
    Eigen::VectorXd means(1000);
    for (Index b = 0; b < means.size(); ++b)
        means[b] = values.segment(50 * b, 50).mean();
    return means;
}

} // namespace

class TestAutomaticLength : public QObject
{
    Q_OBJECT

private slots:
    void slowRinging_isNoEndOfThePlateau_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.0005, 0.002, 0.01, 0.02, 0.05})
            QTest::addRow("zeta %g", zeta) << zeta;
    }

    void slowRinging_isNoEndOfThePlateau()
    {
        QFETCH(double, zeta);
        for (double period = 200.0; period < 12000.0; period *= 1.07)
            for (const double share : {1.0, 0.3}) {
                const Index length = lengthOf(response({{period, zeta, share}}));
                QVERIFY2(length == kSamples, qPrintable(QString::number(period)));
            }
    }

    void severalModes_areNoEndEither()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> between(0.0, 1.0);
        for (unsigned i = 0; i < 60; ++i) {
            std::vector<Mode> modes;
            for (int k = 0; k < 3; ++k)
                modes.push_back({400.0 + 3100.0 * between(random), 0.001 + 0.03 * between(random),
                    0.2 + 0.3 * between(random)});
            QCOMPARE(lengthOf(response(modes, fallAt(2.0 * kSamples, 1.0), i)), kSamples);
        }
    }

    void endBehindSlowRinging_isFound_data()
    {
        QTest::addColumn<double>("period");
        QTest::addColumn<double>("end");
        QTest::addColumn<double>("fall");
        for (const double period : {300.0, 500.0, 1500.0})
            for (const double end : {12000.0, 20000.0, 35000.0})
                for (const double fall : {50.0, 500.0})
                    QTest::addRow("%g, %g, %g", period, end, fall) << period << end << fall;
    }

    void endBehindSlowRinging_isFound()
    {
        QFETCH(double, period);
        QFETCH(double, end);
        QFETCH(double, fall);
        // What is kept ends before the fall, and lacks two periods or a fifth at most.
        const auto length
            = static_cast<double>(lengthOf(response({{period, 0.02, 1.0}}, fallAt(end, fall))));
        QVERIFY2(length < end, qPrintable(QString::number(length)));
        QVERIFY2(length > 0.9 * end - 2.0 * period, qPrintable(QString::number(length)));
    }

    void plateauWithoutRinging_endsWhereItDid()
    {
        for (const double end : {5000.0, 20000.0, 40000.0}) {
            const Index length = lengthOf(response({}, fallAt(end, 50.0)));
            QVERIFY(std::abs(static_cast<double>(length) / (0.9 * end) - 1.0) < 0.02);
        }
        QCOMPARE(lengthOf(response({})), kSamples);
        for (const Index few : {1, 7, 8, 40, 200})
            QCOMPARE(lengthOf(response({}).head(few)), few);
    }

    /// The level leaves its plateau by and by, down or up, behind ringing or a slow beginning.
    void gradualEnd_isFound_data()
    {
        QTest::addColumn<double>("end");
        QTest::addColumn<double>("time");
        QTest::addColumn<double>("change");
        for (const double end : {8000.0, 15000.0, 25000.0})
            for (const double time : {0.1, 0.3, 0.5})
                for (const double change : {-0.1, 0.1, -0.15, -0.6})
                    QTest::addRow("%g, %g, %g", end, time, change) << end << time * end << change;
    }
    void gradualEnd_isFound()
    {
        QFETCH(double, end);
        QFETCH(double, time);
        QFETCH(double, change);
        const auto later = [&](double t) {
            return t < end ? 0.0 : change * (1.0 - std::exp(-(t - end) / time));
        };
        const auto slow = [&](double t) { return later(t) - std::exp(-t / (0.05 * end)); };
        std::vector<Eigen::VectorXd> records{response({}, slow)};
        for (const std::vector<Mode> &modes :
            {std::vector<Mode>{}, {{30.0, 0.02, 1.0}}, {{200.0, 0.02, 1.0}}, {{500.0, 0.2, 1.0}}})
            records.push_back(response(modes, later));
        for (const Eigen::VectorXd &record : records) {
            const auto length = static_cast<double>(lengthOf(record));
            QVERIFY2(length < end, qPrintable(QString::number(length)));
            QVERIFY2(length > 0.8 * end, qPrintable(QString::number(length)));
        }
    }

    /// An amplifier that lets no constant pressure through, and heat: no end of the plateau.
    void droop_isNoEnd()
    {
        for (double time = 0.1 * kSamples; time < 30.0 * kSamples; time *= 1.5) {
            const auto coupled = [&](double t) { return std::exp(-t / time) - 1.0; };
            const auto heat = [&](double t) { return -0.2 * std::sqrt(t / kSamples); };
            const auto ramp = [&](double t) { return -0.3 * t / time; };
            for (const std::vector<Mode> &modes :
                {std::vector<Mode>{}, {{30.0, 0.02, 1.0}}, {{500.0, 0.1, 1.0}}}) {
                QCOMPARE(lengthOf(response(modes, coupled)), kSamples);
                QCOMPARE(lengthOf(response(modes, heat)), kSamples);
                QCOMPARE(lengthOf(response(modes, ramp)), kSamples);
            }
        }
    }

    /// A plateau of 0.2 to 2 % of the record.
    void plateauOfALongRecord_endsWhereItDid_data()
    {
        QTest::addColumn<double>("end");
        QTest::addColumn<double>("period");
        QTest::addColumn<double>("zeta");
        const bool isLong = trials::count(0, 1) > 0;
        for (const double end : isLong ? std::vector<double>{1500.0, 3000.0, 7e3, 15e3}
                                       : std::vector<double>{1500.0, 15e3})
            for (const double period : {30.0, 100.0, 300.0})
                for (const double zeta : {0.02, 0.2})
                    if (end > 20.0 * period)
                        QTest::addRow("%g, %g, %g", end, period, zeta) << end << period << zeta;
    }
    void plateauOfALongRecord_endsWhereItDid()
    {
        QFETCH(double, end);
        QFETCH(double, period);
        QFETCH(double, zeta);
        for (const double later : {-0.6, 1.0}) {
            const auto leaves = [&](double t) { return t < end ? 0.0 : later; };
            const auto length
                = static_cast<double>(lengthOf(response({{period, zeta, 1.0}}, leaves, 1, kLong)));
            QVERIFY2(length < end, qPrintable(QString::number(length)));
            QVERIFY2(length > 0.85 * end - 2.0 * period, qPrintable(QString::number(length)));
        }
    }

    /// Ringing of any period and damping, of one mode and of two.
    void longRecordThatRings_isUsedWhole_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.0005, 0.005, 0.05, 0.2, 0.3, 0.5, 0.9})
            QTest::addRow("zeta %g", zeta) << zeta;
    }
    void longRecordThatRings_isUsedWhole()
    {
        QFETCH(double, zeta);
        const double factor = trials::count(0, 1) > 0 ? 1.07 : 4.0;
        for (double period = 23.0; period < 100e3; period *= factor)
            for (const double second : {0.0, 0.3}) {
                const std::vector<Mode> modes{
                    {period, zeta, 1.0 - second}, {0.31 * period, 0.02, second}};
                const auto still = [](double) { return 0.0; };
                const Index length = lengthOf(response(modes, still, 1, kLong));
                QVERIFY2(length == kLong,
                    qPrintable(QString("%1, %2: %3").arg(period).arg(second).arg(length)));
            }
    }

    /// Slow beginnings, slow ends and echoes end no plateau.
    void longRecordThatSettles_isUsedWhole()
    {
        const auto whole = [](const std::function<double(double)> &less, const QString &what) {
            const Index length = lengthOf(response({}, less, 1, kLong));
            QVERIFY2(length == kLong, qPrintable(what + QString(": %1").arg(length)));
        };
        for (double time = 10.0; time < 3e5; time *= 10.0) {
            const auto gone = [time](double t) { return std::exp(-t / time); };
            whole([&](double t) { return -gone(t); }, QString("lag of %1").arg(time));
            whole([&](double t) { return -0.8 * std::exp(-t / 50.0) - 0.2 * gone(t); },
                QString("lag and creep of %1").arg(time));
            const auto chain = [&](double t) { // six lags one behind the other
                double sum = 0.0, term = 1.0;
                for (int k = 1; k <= 6; term *= t / time / k++)
                    sum += term;
                return -gone(t) * sum;
            };
            whole(chain, QString("six lags of %1").arg(time));
            if (time > 1e4)
                continue; // from there on the look at all of the record sees 3 %
            for (const double size : {-0.08, 0.08})
                whole([&](double t) { return t < time ? 0.0 : size; },
                    QString("echo of %1 behind %2").arg(size).arg(time));
        }
    }

    void period_isFound()
    {
        for (const double period : {300.0, 777.0, 3000.0, 9000.0}) {
            const Index found = slowestRinging_blocks(levels(response({{period, 0.005, 0.5}})));
            // To a bin: the record has count/period of them.
            const double bins = 50000.0 / period;
            QVERIFY(std::abs(50.0 * static_cast<double>(found) / period - 1.0)
                < 1.0 / bins + 50.0 / period);
        }
        const Index slowest
            = slowestRinging_blocks(levels(response({{2000.0, 0.005, 0.2}, {500.0, 0.005, 0.8}})));
        QVERIFY(std::abs(static_cast<double>(slowest) - 40.0) < 3.0);
    }

    void whatDoesNotRing_hasNoPeriod()
    {
        int found = 0;
        for (unsigned seed = 0; seed < 200; ++seed)
            found
                += slowestRinging_blocks(levels(response({}, fallAt(9e9, 1.0), seed))) > 0 ? 1 : 0;
        QVERIFY2(found <= 2, qPrintable(QString::number(found)));
        QCOMPARE(slowestRinging_blocks(levels(response({}, fallAt(2e4, 50.0)))), Index(0));
        QCOMPARE(slowestRinging_blocks(levels(response({}, fallAt(2e4, 5000.0)))), Index(0));
        QCOMPARE(slowestRinging_blocks(levels(response({}, [](double t) { return 1e-5 * t; }))),
            Index(0));
        Eigen::VectorXd gap = levels(response({{2000.0, 0.005, 0.5}}));
        gap[7] = std::nan("");
        QCOMPARE(slowestRinging_blocks(gap), Index(0));
        QCOMPARE(slowestRinging_blocks(Eigen::VectorXd::Ones(9)), Index(0));
    }
};

DYNCAL_TEST(TestAutomaticLength)
#include "tst_automatic_length.moc"
