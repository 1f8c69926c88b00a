// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/exponential_regression.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <random>

using namespace dyncal;
using Complex = std::complex<double>;

/// Normal equations by matrix products and doubled power sums are those of the Jacobian written
/// out.
class TestExponentialRegression : public QObject
{
    Q_OBJECT

private slots:
    void equations_equalThoseOfTheFullJacobian();
    void equations_gradientIsMinusHalfOfTheCostsSlope();
    void equations_ofTheModelItself_haveNoCost();
    void equations_overRanges_leaveTheOthersOut();

private:
    static double valueOf(const std::vector<RegressionMode> &modes, Index k)
    {
        double value = 0.0;
        for (const RegressionMode &mode : modes)
            value += (mode.gain * std::exp(mode.exponent * static_cast<double>(k))).real();
        return value;
    }

    static std::vector<RegressionMode> someModes()
    {
        return {{{-1e-3, 0.4}, {0.7, -0.3}, true, false}, {{-2e-2, 2.9}, {0.1, 0.2}, true, false},
            {{-5e-4, 0.0}, {-0.2, 0.0}, false, false}, {0.0, {1.0, 0.0}, false, true}};
    }

    static Eigen::VectorXd noisy(const std::vector<RegressionMode> &modes, Index count)
    {
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0.0, 0.1);
        Eigen::VectorXd y(count);
        for (Index k = 0; k < count; ++k)
            y[k] = valueOf(modes, k) + noise(random);
        return y;
    }

    /// Derivatives of the model at sample k, in the order of the parameters.
    static Eigen::VectorXd rowOf(const std::vector<RegressionMode> &modes, Index k, double dt)
    {
        std::vector<double> row;
        const double t = static_cast<double>(k) * dt;
        const auto power = [&](const RegressionMode &mode) {
            return std::exp(mode.exponent * static_cast<double>(k));
        };
        for (const RegressionMode &mode : modes) {
            if (mode.isFixed)
                continue;
            row.push_back(t * (mode.gain * power(mode)).real());
            if (mode.isPair)
                row.push_back(-t * (mode.gain * power(mode)).imag());
        }
        for (const RegressionMode &mode : modes) {
            row.push_back(power(mode).real());
            if (mode.isPair)
                row.push_back(-power(mode).imag());
        }
        return Eigen::Map<Eigen::VectorXd>(row.data(), std::ssize(row));
    }
};

void TestExponentialRegression::equations_equalThoseOfTheFullJacobian()
{
    const double dt = 0.37;
    constexpr double kRounding = 1e-11;
    for (const Index count : {Index(1), Index(127), Index(128), Index(129), Index(3000)}) {
        std::vector<RegressionMode> modes = someModes();
        const Eigen::VectorXd y = noisy(modes, count);
        modes[0].exponent *= 1.001; // away from the minimum
        modes[2].gain += 0.1;
        const RegressionEquations found = ExponentialRegression(y).equations(modes, dt);
        const Index parameters = 5 + 6;
        Eigen::MatrixXd jacobian(count, parameters);
        Eigen::VectorXd residual(count);
        for (Index k = 0; k < count; ++k) {
            jacobian.row(k) = rowOf(modes, k, dt).transpose();
            residual[k] = y[k] - valueOf(modes, k);
        }
        const Eigen::MatrixXd matrix = jacobian.transpose() * jacobian;
        const Eigen::VectorXd gradient = jacobian.transpose() * residual;
        QCOMPARE(found.matrix.rows(), parameters);
        const Eigen::VectorXd norms = matrix.diagonal().cwiseSqrt();
        for (Index a = 0; a < parameters; ++a) {
            QVERIFY(std::abs(found.gradient[a] - gradient[a])
                <= kRounding * (norms[a] * residual.norm() + 1e-300));
            for (Index b = 0; b < parameters; ++b)
                QVERIFY(std::abs(found.matrix(a, b) - matrix(a, b))
                    <= kRounding * (norms[a] * norms[b] + 1e-300));
        }
        QVERIFY(std::abs(found.cost - residual.squaredNorm()) <= kRounding * y.squaredNorm());
    }
}

void TestExponentialRegression::equations_overRanges_leaveTheOthersOut()
{
    const double dt = 0.37;
    constexpr double kRounding = 1e-11;
    constexpr Index kCount = 900;
    std::vector<RegressionMode> modes = someModes();
    const Eigen::VectorXd y = noisy(modes, kCount);
    modes[0].exponent *= 1.001; // away from the minimum
    const std::vector<SampleRange> used{{3, 4}, {10, 127}, {128, 300}, {700, 899}};
    Eigen::MatrixXd matrix;
    Eigen::VectorXd gradient;
    double cost = 0.0;
    Index samples = 0;
    for (const SampleRange &range : used) {
        for (Index k = range.begin; k < range.end; ++k, ++samples) {
            const Eigen::VectorXd row = rowOf(modes, k, dt);
            const double residual = y[k] - valueOf(modes, k);
            if (samples == 0) {
                matrix = Eigen::MatrixXd::Zero(row.size(), row.size());
                gradient = Eigen::VectorXd::Zero(row.size());
            }
            matrix += row * row.transpose();
            gradient += residual * row;
            cost += residual * residual;
        }
    }
    const ExponentialRegression regression(y, used);
    const RegressionEquations found = regression.equations(modes, dt);
    QCOMPARE(regression.count(), samples);
    QVERIFY((found.matrix - matrix).norm() < kRounding * matrix.norm());
    QVERIFY((found.gradient - gradient).norm() < kRounding * matrix.norm());
    QVERIFY(std::abs(found.cost - cost) < kRounding * cost);
}

void TestExponentialRegression::equations_gradientIsMinusHalfOfTheCostsSlope()
{
    const double dt = 1.0;
    std::vector<RegressionMode> modes = someModes();
    const ExponentialRegression regression(noisy(modes, 500));
    modes[1].gain *= 1.2;
    const RegressionEquations here = regression.equations(modes, dt);
    const double h = 1e-6;
    const auto slope = [&](auto move) {
        std::vector<RegressionMode> up = modes;
        std::vector<RegressionMode> down = modes;
        move(up, h);
        move(down, -h);
        return (regression.equations(up, dt).cost - regression.equations(down, dt).cost) / (2 * h);
    };
    const double bySigma = slope([](auto &m, double d) { m[1].exponent += d; });
    const double byOmega = slope([](auto &m, double d) { m[1].exponent += Complex(0.0, d); });
    const double byGain = slope([](auto &m, double d) { m[1].gain += Complex(0.0, d); });
    constexpr double kDifference = 1e-4; // of a central difference with step 1e-6
    QVERIFY(std::abs(bySigma + 2 * here.gradient[2]) < kDifference * (1 + std::abs(bySigma)));
    QVERIFY(std::abs(byOmega + 2 * here.gradient[3]) < kDifference * (1 + std::abs(byOmega)));
    QVERIFY(std::abs(byGain + 2 * here.gradient[8]) < kDifference * (1 + std::abs(byGain)));
}

void TestExponentialRegression::equations_ofTheModelItself_haveNoCost()
{
    const std::vector<RegressionMode> modes = someModes();
    Eigen::VectorXd y(10000);
    for (Index k = 0; k < y.size(); ++k)
        y[k] = valueOf(modes, k);
    const RegressionEquations found = ExponentialRegression(y).equations(modes, 1.0);
    QVERIFY(std::sqrt(found.cost / static_cast<double>(y.size())) < 1e-13);
}

DYNCAL_TEST(TestExponentialRegression)
#include "tst_exponential_regression.moc"
