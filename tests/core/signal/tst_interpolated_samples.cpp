// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Records written at a higher rate than measured.

#include "core/signal/interpolated_samples.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

constexpr double kCode = 0.01;

/// A decaying wave with noise of some codes, rounded to codes or not.
Eigen::VectorXd measured(Index samples, unsigned seed, double noise = 0.1, bool isRounded = true)
{
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal(0.0, noise);
    Eigen::VectorXd values(samples);
    for (Index i = 0; i < samples; ++i) {
        const double t = static_cast<double>(i);
        values[i] = std::exp(-t / 400.0) * std::sin(0.2 * t) + normal(engine);
        if (isRounded)
            values[i] = kCode * std::round(values[i] / kCode);
    }
    return values;
}

Eigen::VectorXd written(
    const Eigen::VectorXd &values, Index factor, bool isRepeated, bool isRounded)
{
    Eigen::VectorXd more((values.size() - 1) * factor);
    for (Index i = 0; i < more.size(); ++i) {
        const Index at = i / factor;
        const double share
            = isRepeated ? 0.0 : static_cast<double>(i % factor) / static_cast<double>(factor);
        more[i] = (1.0 - share) * values[at] + share * values[at + 1];
        if (isRounded)
            more[i] = kCode * std::round(more[i] / kCode);
    }
    return more;
}

} // namespace

class TestInterpolatedSamples : public QObject
{
    Q_OBJECT

private slots:
    void factor_isFound()
    {
        for (unsigned seed = 1; seed <= 10; ++seed)
            for (const Index factor : {2, 3, 4, 5, 10})
                for (const bool isRepeated : {false, true})
                    for (const bool isRounded : {false, true}) {
                        if (isRounded && factor == 10)
                            continue; // the bends of the noise are as small as those of rounding
                        const auto found = interpolatedSamples(
                            written(measured(800, seed), factor, isRepeated, isRounded),
                            isRounded ? kCode : kCode / static_cast<double>(factor));
                        QVERIFY(found);
                        QCOMPARE(found->factor, factor);
                        QCOMPARE(found->isRepeated, isRepeated);
                    }
    }

    void measuredRecords_areNone()
    {
        for (unsigned seed = 1; seed <= 200; ++seed)
            for (const double noise : {0.0, 0.002, 0.03})
                for (const bool isRounded : {false, true})
                    QVERIFY(!interpolatedSamples(
                        measured(4000, seed, noise, isRounded), isRounded ? kCode : 0.0));
        QVERIFY(!interpolatedSamples(Eigen::VectorXd::Zero(4000), kCode));
        QVERIFY(!interpolatedSamples(Eigen::VectorXd::LinSpaced(4000, 0.0, 1.0), 0.0));
        for (const Index few : {0, 1, 2, 3, 20})
            QVERIFY(!interpolatedSamples(Eigen::VectorXd::LinSpaced(few, 0.0, 1.0), 0.0));
    }

    /// Ringing whose period is a whole number of samples, in coarse codes.
    void periodicRecords_areNone()
    {
        for (const Index period : {4, 8, 16, 32}) {
            Eigen::VectorXd values(4000);
            for (Index i = 0; i < values.size(); ++i)
                values[i] = std::round(5.0
                    * std::sin(2.0 * 3.14159265358979 * (static_cast<double>(i) + 0.3)
                        / static_cast<double>(period)));
            QVERIFY(!interpolatedSamples(values, 1.0));
        }
    }
};

DYNCAL_TEST(TestInterpolatedSamples)
#include "tst_interpolated_samples.moc"
