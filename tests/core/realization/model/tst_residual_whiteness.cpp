// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/residual_whiteness.h"
#include "tests/support/simulated_calibration.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

namespace {

constexpr int kTrials = 400;
constexpr Index kSamples = 2000;

/// x_k = a x_(k-1) + e_k, e of unit variance.
Eigen::VectorXd coloured(double a, Index count, std::uint64_t seed)
{
    Eigen::VectorXd x = testing::Noise(seed).series(count, 1.0);
    for (Index k = 1; k < count; ++k)
        x[k] += a * x[k - 1];
    return x;
}

/// p value of one series with the noise before the start and what the model leaves.
double p_of(const Eigen::VectorXd &before, const Eigen::VectorXd &left)
{
    ModelInput input;
    input.series.emplace_back().noise = before;
    SensorModel model;
    model.series.emplace_back().error = left;
    return residualWhiteness_p(input, model);
}

/// Share of trials with a p value below `limit`: noise and residual are AR(1) of these poles.
double shareBelow(double limit, double noisePole, double residualPole)
{
    int below = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        const auto seed = 2 * static_cast<std::uint64_t>(trial) + 1;
        below
            += p_of(coloured(noisePole, kSamples, seed), coloured(residualPole, kSamples, seed + 1))
            < limit;
    }
    return static_cast<double>(below) / kTrials;
}

} // namespace

class TestResidualWhiteness : public QObject
{
    Q_OBJECT

private slots:
    void residualOfTheNoisesColour_isRejectedAsRarelyAsStated_data()
    {
        QTest::addColumn<double>("pole");
        QTest::newRow("white") << 0.0;
        QTest::newRow("red") << 0.8;
        QTest::newRow("blue") << -0.5;
    }

    /// 400 trials, seeds 1 to 800: 5 % are 20 with a deviation of 4.4, so 33 are three of these.
    void residualOfTheNoisesColour_isRejectedAsRarelyAsStated()
    {
        QFETCH(double, pole);
        const double share = shareBelow(0.05, pole, pole);
        qInfo("p below 0.05 in %.1f %% of %d trials", 100.0 * share, kTrials);
        QVERIFY(share <= 33.0 / kTrials);
    }

    void anotherColour_isSeen()
    {
        QVERIFY(shareBelow(0.01, 0.0, 0.25) > 0.95);
        QVERIFY(shareBelow(0.01, 0.8, 0.9) > 0.95);
    }

    void aResonanceLeftBehind_isSeen()
    {
        Eigen::VectorXd left = coloured(0.0, kSamples, 7);
        for (Index k = 0; k < kSamples; ++k)
            left[k] += 0.5 * std::cos(0.6 * static_cast<double>(k));
        QVERIFY(p_of(coloured(0.0, kSamples, 8), left) < 1e-6);
    }

    void levelAndScale_doNotCount()
    {
        const Eigen::VectorXd before = coloured(0.0, kSamples, 1);
        const Eigen::VectorXd left = coloured(0.0, kSamples, 2);
        const double p = p_of(before, left);
        QVERIFY(std::abs(p_of(1e-6 * before, 1e-6 * left) - p) < 1e-6);
        QVERIFY(std::abs(p_of(before, 30.0 * left) - p) < 1e-6);
    }

    void whatCannotBeAsked_isUnknown()
    {
        const Eigen::VectorXd before = coloured(0.0, kSamples, 1);
        QVERIFY(std::isnan(p_of(before, coloured(0.0, 80, 2))));
        QVERIFY(std::isnan(p_of(before, Eigen::VectorXd::Zero(kSamples))));
        QVERIFY(!std::isnan(p_of(before, coloured(0.0, 120, 2))));

        ModelInput input;
        input.series.emplace_back().noise = before;
        SensorModel diverging;
        diverging.series.emplace_back().error = before;
        diverging.diverges = true;
        QVERIFY(std::isnan(residualWhiteness_p(input, diverging)));
    }

    void withoutNoiseBeforeTheStart_whiteIsWhatIsAskedFor()
    {
        QVERIFY(p_of({}, coloured(0.0, kSamples, 3)) > 1e-3);
        QVERIFY(p_of({}, coloured(0.3, kSamples, 3)) < 1e-6);
    }
};

DYNCAL_TEST(TestResidualWhiteness)
#include "tst_residual_whiteness.moc"
