// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A record that moves before its start, and one that does not.

#include "core/signal/unrest.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace dyncal;

namespace {

constexpr double kLeast = 0.003;
constexpr Index kSamples = 20000;

/// AR(1) noise of that standard deviation.
Eigen::VectorXd noise(Index samples, double sd, double memory, unsigned seed)
{
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal(0.0, sd * std::sqrt(1.0 - memory * memory));
    Eigen::VectorXd values(samples);
    double last = 0.0;
    for (double &value : values)
        value = last = memory * last + normal(engine);
    return values;
}

Eigen::VectorXd with(Eigen::VectorXd values, const std::function<double(double)> &more)
{
    for (Index i = 0; i < values.size(); ++i)
        values[i] += more(static_cast<double>(i));
    return values;
}

/// Ringing that begins at `begin`.
std::function<double(double)> wave(double begin, double period, double size, double zeta = 0.02)
{
    return [=](double t) {
        const double turn = 2.0 * std::numbers::pi * (t - begin) / period;
        return t < begin ? 0.0 : size * std::exp(-zeta * turn) * std::sin(turn);
    };
}

} // namespace

class TestUnrest : public QObject
{
    Q_OBJECT

private slots:
    void precursor_isFound_data()
    {
        QTest::addColumn<double>("lead");
        QTest::addColumn<double>("period");
        QTest::addColumn<double>("size");
        for (const double lead : {300.0, 500.0, 1000.0, 5000.0})
            for (const double period : {100.0, 500.0, 1200.0})
                for (const double size : {0.01, 0.02, 0.05})
                    if (lead >= period && (size > 0.01 || lead == 1000.0))
                        QTest::addRow("%g, %g, %g", lead, period, size) << lead << period << size;
    }
    void precursor_isFound()
    {
        QFETCH(double, lead);
        QFETCH(double, period);
        QFETCH(double, size);
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const auto found = unrestBefore(
                with(noise(kSamples, 0.005, 0.0, seed), wave(kSamples - lead, period, size)),
                kLeast);
            QVERIFY(found);
            QVERIFY(static_cast<double>(found->begin) > kSamples - lead - 600.0);
            QVERIFY(found->size > 2.0 * found->usual / 1.5);
        }
    }

    /// What is left of a response that began before the record.
    void decayAtTheBeginning_isFound()
    {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const auto found = unrestBefore(
                with(noise(kSamples, 0.005, 0.0, seed), wave(0.0, 31.0, 0.03)), kLeast);
            QVERIFY(found);
            QVERIFY(found->begin < 600);
        }
    }

    /// White and coloured noise; the last one remembers longer than a piece lasts.
    void whatIsAlikeThroughout_isQuiet_data()
    {
        QTest::addColumn<double>("memory");
        QTest::addColumn<double>("mostTold");
        QTest::newRow("white") << 0.0 << 0.001;
        QTest::newRow("AR(0.9)") << 0.9 << 0.001;
        QTest::newRow("AR(0.999)") << 0.999 << 0.01;
    }
    void whatIsAlikeThroughout_isQuiet()
    {
        QFETCH(double, memory);
        QFETCH(double, mostTold);
        const Index trials = trials::count(200, 10000);
        Index told = 0, all = 0;
        for (unsigned seed = 1; seed <= trials; ++seed)
            for (const Index samples : {700, 5000, 20000}) {
                ++all;
                told += unrestBefore(noise(samples, 0.01, memory, seed), kLeast) ? 1 : 0;
            }
        QVERIFY2(static_cast<double>(told) <= mostTold * static_cast<double>(all),
            qPrintable(QString("%1 of %2").arg(told).arg(all)));
    }

    /// Hum, drift, spikes, and coarse codes.
    void humDriftSpikesAndCodes_areQuiet()
    {
        for (unsigned seed = 1; seed <= 50; ++seed) {
            const Eigen::VectorXd still = noise(kSamples, 0.003, 0.0, seed);
            for (const double period : {500.0, 1e3, 2e3, 5e3, 2e4, 2e5})
                QVERIFY(!unrestBefore(with(still, wave(-1.0, period, 0.05, 0.0)), kLeast));
            QVERIFY(!unrestBefore(with(still, [](double t) { return 1e-5 * t; }), kLeast));
            const auto spike = [](double t) { return t > 19000.0 && t < 19010.0 ? 0.5 : 0.0; };
            QVERIFY(!unrestBefore(with(still, spike), kLeast));
            Eigen::VectorXd codes = still;
            for (double &value : codes)
                value = 0.02 * std::round(value / 0.02);
            QVERIFY(!unrestBefore(codes, 0.02));
        }
    }

    void softBeginning_isLeftOut()
    {
        const auto begins
            = [](double t) { return t > 19900.0 ? 4e-7 * std::pow(t - 19900.0, 2) : 0.0; };
        QVERIFY(!unrestBefore(with(noise(kSamples, 0.001, 0.0, 1), begins), kLeast));
    }

    void tooFewSamples_sayNothing()
    {
        for (const Index few : {0, 1, 31, 200})
            QVERIFY(!unrestBefore(
                with(Eigen::VectorXd::Zero(few), wave(0.5 * static_cast<double>(few), 20.0, 1.0)),
                kLeast));
        QVERIFY(!unrestBefore(Eigen::VectorXd::Zero(1000), kLeast));
        QVERIFY(unrestBefore(with(Eigen::VectorXd::Zero(1000), wave(900.0, 20.0, 1.0)), kLeast));
    }
};

DYNCAL_TEST(TestUnrest)
#include "tst_unrest.moc"
