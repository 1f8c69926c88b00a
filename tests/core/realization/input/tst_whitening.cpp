// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/whitening.h"
#include "tests/support/simulated_calibration.h"
#include "tests/support/test_program.h"

#include <Eigen/Cholesky>

#include <QTest>

using namespace dyncal;

namespace {

constexpr Index kCount = 20000;
constexpr double kStatistical = 0.035; ///< 1/sqrt(20000) is 0.007: five times that

/// x_k = 1.2 x_(k-1) - 0.5 x_(k-2) + e_k, e of unit variance.
Eigen::VectorXd secondOrderNoise(Index count, std::uint64_t seed)
{
    Eigen::VectorXd x = testing::Noise(seed).series(count, 1.0);
    for (Index k = 2; k < count; ++k)
        x[k] += 1.2 * x[k - 1] - 0.5 * x[k - 2];
    return x;
}

double autocorrelation(const Eigen::VectorXd &x, Index lag)
{
    return x.head(x.size() - lag).dot(x.tail(x.size() - lag)) / x.squaredNorm();
}

} // namespace

class TestWhitening : public QObject
{
    Q_OBJECT

private slots:
    void autoregressiveNoise_becomesWhite()
    {
        const Eigen::VectorXd x = secondOrderNoise(kCount, 11);
        const AutoregressiveModel model = autoregressiveModel(noiseCovariance(x, 2), 2);
        QVERIFY(std::abs(model.coefficients[0] + 1.2) < kStatistical);
        QVERIFY(std::abs(model.coefficients[1] - 0.5) < kStatistical);
        QVERIFY(std::abs(model.innovationVariance - 1.0) < kStatistical);
        QVERIFY(std::abs(autocorrelation(whitened(x, model.coefficients), 1)) < kStatistical);
    }

    void levinson_solvesTheYuleWalkerEquations()
    {
        // Independent solution of the same equations by a Cholesky factorisation.
        constexpr Index kOrder = 6;
        const NoiseCovariance r = noiseCovariance(secondOrderNoise(500, 3), kOrder);
        Eigen::MatrixXd toeplitz(kOrder, kOrder);
        for (Index i = 0; i < kOrder; ++i) {
            for (Index k = 0; k < kOrder; ++k)
                toeplitz(i, k) = r.values[std::abs(i - k)];
        }
        const Eigen::VectorXd a = -toeplitz.ldlt().solve(r.values.tail(kOrder));
        const AutoregressiveModel model = autoregressiveModel(r, kOrder);
        QVERIFY((model.coefficients - a).cwiseAbs().maxCoeff() < 1e-12);
        const double variance = r.values[0] + a.dot(r.values.tail(kOrder));
        QVERIFY(std::abs(model.innovationVariance / variance - 1.0) < 1e-12);
    }

    void covariance_isOfTheDeviationsFromTheMean()
    {
        Eigen::VectorXd x(4);
        x << 11.0, 9.0, 12.0, 8.0; // deviations 1, -1, 2, -2
        const NoiseCovariance r = noiseCovariance(x, 10);
        QCOMPARE(r.count, Index(4));
        QCOMPARE(r.values.size(), Index(4));
        const Eigen::Vector4d expected(10.0 / 4.0, -7.0 / 4.0, 4.0 / 4.0, -2.0 / 4.0);
        QVERIFY((r.values - expected).cwiseAbs().maxCoeff() < 1e-15);
        QCOMPARE(noiseCovariance(Eigen::VectorXd(), 5).values.size(), Index(0));
    }

    void chosenOrder_isThatOfTheNoise()
    {
        int white = 0;
        int second = 0;
        constexpr int kTrials = 50;
        for (std::uint64_t seed = 1; seed <= kTrials; ++seed) {
            const Eigen::VectorXd flat = testing::Noise(seed).series(1000, 0.3);
            const Eigen::VectorXd coloured = secondOrderNoise(1000, seed);
            white += chooseAutoregressiveModels({noiseCovariance(flat, 8)}, 8)[0].order() == 0;
            second += chooseAutoregressiveModels({noiseCovariance(coloured, 8)}, 8)[0].order() == 2;
        }
        qInfo("white noise: %d of 50; second order: %d of 50", white, second);
        QVERIFY(white >= 45 && second >= 45);
    }

    void records_shareTheOrder_notTheCoefficients()
    {
        RandomStream random(1, 1, 1);
        const auto weak = noiseCovariance(testing::simulatedNoise(random, 2000, 1.0, 0.5), 8);
        const auto strong = noiseCovariance(testing::simulatedNoise(random, 2000, 2.0, 0.9), 8);
        const auto models = chooseAutoregressiveModels({weak, strong}, 8);
        QCOMPARE(models[0].order(), Index(1));
        QCOMPARE(models[1].order(), Index(1));
        // sd of a coefficient is sqrt((1 - a^2)/N) < 0.02: four times that
        QVERIFY(std::abs(models[0].coefficients[0] + 0.5) < 0.08);
        QVERIFY(std::abs(models[1].coefficients[0] + 0.9) < 0.08);
    }

    void tooShortOrFlatNoise_isLeftWhite()
    {
        const auto order = [](const Eigen::VectorXd &x) {
            return chooseAutoregressiveModels({noiseCovariance(x, 8)}, 8).front().order();
        };
        QCOMPARE(order(secondOrderNoise(19, 1)), Index(0));
        QCOMPARE(order(Eigen::VectorXd::Constant(500, 3.0)), Index(0));
        QCOMPARE(order(Eigen::VectorXd()), Index(0));
        QCOMPARE(order(Eigen::VectorXd::Constant(1, 3.0)), Index(0));
        // One flat record among others keeps all of them white: no common order exists.
        const auto models
            = chooseAutoregressiveModels({noiseCovariance(secondOrderNoise(500, 1), 8),
                                             noiseCovariance(Eigen::VectorXd::Zero(500), 8)},
                8);
        QCOMPARE(models[0].order(), Index(0));
        QVERIFY(chooseAutoregressiveModels({}, 8).empty());
    }

    void predictableNoise_endsTheSearch()
    {
        // A pure alternation is predicted by one coefficient: nothing may become negative or NaN.
        Eigen::VectorXd x(400);
        for (Index k = 0; k < x.size(); ++k)
            x[k] = k % 2 ? 1.0 : -1.0;
        for (const AutoregressiveModel &model :
            chooseAutoregressiveModels({noiseCovariance(x, 8)}, 8)) {
            QVERIFY(model.innovationVariance > 0.0);
            QVERIFY(model.coefficients.allFinite());
        }
    }

    void filter_ofNoCoefficients_isTheRecord()
    {
        const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, 0.0, 8.0);
        QCOMPARE(whitened(x, {}), x);
    }

    void filter_multipliesAnExponentialByAConstant()
    {
        const Eigen::Vector2d a(-1.2, 0.5);
        Eigen::VectorXd x(50);
        for (Index k = 0; k < x.size(); ++k)
            x[k] = std::pow(0.8, static_cast<double>(k));
        const Eigen::VectorXd y = whitened(x, a);
        const double gain = 1.0 - 1.2 / 0.8 + 0.5 / 0.64;
        QCOMPARE(y.size(), Index(48));
        QVERIFY((y - gain * x.tail(48)).cwiseAbs().maxCoeff() < 1e-14);
    }
};

DYNCAL_TEST(TestWhitening)
#include "tst_whitening.moc"
