// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/eigenvalues.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/realized_poles.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

/// A discrete system, x(k+1) = A x(k), observed after its start: y(k) = C A^k B.
struct System
{
    Eigen::MatrixXd A, B, C;
};

/// Row i * inputs + j: the series from input j to output i.
Eigen::MatrixXd markovParameters(const System &system, Index count)
{
    Eigen::MatrixXd series(system.C.rows() * system.B.cols(), count);
    Eigen::MatrixXd state = system.B;
    for (Index k = 0; k < count; ++k) {
        const Eigen::MatrixXd h = (system.C * state).transpose();
        series.col(k) = h.reshaped();
        state = (system.A * state).eval();
    }
    return series;
}

/// e^A by its series on A / 2^12.
Eigen::MatrixXd exponential(const Eigen::MatrixXd &A)
{
    const Eigen::MatrixXd small = A / 4096.0;
    Eigen::MatrixXd term = Eigen::MatrixXd::Identity(A.rows(), A.cols());
    Eigen::MatrixXd sum = term;
    for (int n = 1; n < 20; ++n) {
        term = term * small / static_cast<double>(n);
        sum += term;
    }
    for (int doubling = 0; doubling < 12; ++doubling)
        sum = (sum * sum).eval();
    return sum;
}

/// M q'' + D q' + K q = f as x' = A x, x = (q, q').
Eigen::MatrixXd mechanicalSystem(
    const Eigen::VectorXd &masses, const Eigen::MatrixXd &K, const Eigen::MatrixXd &D)
{
    const Index n = masses.size();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    A.topRightCorner(n, n).setIdentity();
    A.bottomLeftCorner(n, n) = -(masses.cwiseInverse().asDiagonal() * K);
    A.bottomRightCorner(n, n) = -(masses.cwiseInverse().asDiagonal() * D);
    return A;
}

ModelInput inputOf(const Eigen::MatrixXd &rows, ResponseTreatment treatment, double rate_Hz)
{
    std::vector<ModelSeries> series;
    for (Index i = 0; i < rows.rows(); ++i)
        series.push_back(testing::makeSeries(i + 1, rows.row(i).transpose(), rate_Hz));
    return testing::makeInput(treatment, rate_Hz, std::move(series));
}

double distance(const std::vector<std::complex<double>> &poles, const Eigen::VectorXcd &truth)
{
    double worst = 0.0;
    for (const std::complex<double> &p : truth) {
        double nearest = std::abs(poles.front() - p);
        for (const std::complex<double> &z : poles)
            nearest = std::min(nearest, std::abs(z - p));
        worst = std::max(worst, nearest);
    }
    return worst;
}

/// Random stable system: modes with |p| between 0.8 and 0.99, no two alike.
System randomSystem(Index pairs, std::uint64_t seed)
{
    testing::Noise source(seed);
    const Index n = 2 * pairs;
    Eigen::MatrixXd modal = Eigen::MatrixXd::Zero(n, n);
    for (Index i = 0; i < pairs; ++i) {
        const double radius = 0.8 + 0.19 / (1.0 + std::exp(source.next()));
        const double angle = (0.5 + static_cast<double>(i)) * 3.0 / static_cast<double>(pairs);
        modal.block(2 * i, 2 * i, 2, 2) << radius * std::cos(angle), radius * std::sin(angle),
            -radius * std::sin(angle), radius * std::cos(angle);
    }
    System system{modal, Eigen::MatrixXd(n, 1), Eigen::MatrixXd(1, n)};
    for (Index i = 0; i < n; ++i) {
        system.B(i) = 1.0 + 0.3 * source.next();
        system.C(i) = 1.0 + 0.3 * source.next();
    }
    return system;
}

} // namespace

class TestRealizationOracles : public QObject
{
    Q_OBJECT

private slots:
    /// Katayama, Subspace Methods for System Identification, example 6.1; python-control's test.
    void fibonacci_hasTheGoldenRatio()
    {
        const Eigen::MatrixXd y{{0, 1, 1, 2, 3, 5, 8, 13, 21, 34}};
        const double root = std::sqrt(5.0);
        const Eigen::VectorXcd truth{{(1.0 + root) / 2.0, (1.0 - root) / 2.0}};
        for (const auto treatment :
            {ResponseTreatment::StepAsImpulse, ResponseTreatment::Impulse}) {
            const auto hankel = decomposeHankel(inputOf(y, treatment, 1.0), {});
            QVERIFY(hankel->singularValues[2] < 1e-13 * hankel->singularValues[0]);
            QVERIFY(distance(realizedPoles(*hankel, 2), truth) < 1e-9);
        }
        const auto hankel = decomposeHankel(inputOf(y, ResponseTreatment::StepAsImpulse, 1.0), {});
        const Eigen::VectorXd again = impulseResponse(thesisRealization(*hankel, 2, 1.0), 11);
        QVERIFY((again.tail(10) - y.row(0).transpose()).cwiseAbs().maxCoeff() < 1e-9);
    }

    /// pyyeti's test of its ERA (BSD): free decay of three masses of one from v0 = (1, 1, 1).
    void threeMasses_haveTheirFrequenciesAndDampings()
    {
        const Eigen::MatrixXd K{{4185.1498, 576.6947, 3646.8923}, {576.6947, 2104.9252, -28.0450},
            {3646.8923, -28.0450, 3451.5583}};
        const Eigen::MatrixXd D{{4.96765646, 0.97182432, 4.0162425},
            {0.97182432, 6.71403672, -0.86138453}, {4.0162425, -0.86138453, 4.28850828}};
        const double interval_s = 0.01;
        System system;
        system.A = exponential(mechanicalSystem(Eigen::VectorXd::Ones(3), K, D) * interval_s);
        system.B = Eigen::VectorXd{{0, 0, 0, 1, 1, 1}};
        system.C = Eigen::MatrixXd::Identity(6, 6).bottomRows(3); // velocities
        const auto hankel = decomposeHankel(
            inputOf(markovParameters(system, 100), ResponseTreatment::Impulse, 1.0 / interval_s),
            {});
        QVERIFY(hankel->singularValues[6] < 1e-10 * hankel->singularValues[0]);

        std::vector<std::pair<double, double>> modes;
        for (const std::complex<double> &z : realizedPoles(*hankel, 6)) {
            const std::complex<double> s = std::log(z) / interval_s;
            if (s.imag() > 0.0)
                modes.emplace_back(std::abs(s) / (2.0 * std::numbers::pi), -s.real() / std::abs(s));
        }
        std::sort(modes.begin(), modes.end());
        const std::vector<std::pair<double, double>> truth{
            {1.33602878, 0.02}, {7.39083199, 0.075}, {13.79670554, 0.05}};
        QCOMPARE(modes.size(), truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            QVERIFY(std::abs(modes[i].first / truth[i].first - 1.0) < 1e-8); // digits of the oracle
            QVERIFY(std::abs(modes[i].second / truth[i].second - 1.0) < 1e-6);
        }
    }

    /// python-control's two masses and springs. Several inputs and outputs are no case of Dyncal's;
    /// its four channels, stacked as shots are, share their poles, and each alone has them too.
    void twoMasses_everyChannelAndTheStackHaveThePoles()
    {
        const Eigen::MatrixXd K{{6.0, -2.0}, {-2.0, 8.0}};
        const Eigen::MatrixXd D{{2.0, -1.0}, {-1.0, 3.0}};
        System system;
        system.A = exponential(mechanicalSystem(Eigen::VectorXd{{1.0, 2.0}}, K, D) * 0.1);
        system.B = Eigen::MatrixXd{{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 0.5}};
        system.C = Eigen::MatrixXd::Identity(2, 4);
        const Eigen::MatrixXd series = markovParameters(system, 100);
        const Eigen::VectorXcd truth = eigenvalues(system.A);
        const auto together
            = decomposeHankel(inputOf(series, ResponseTreatment::Impulse, 10.0), {});
        QVERIFY(distance(realizedPoles(*together, 4), truth) < 1e-9);
        for (Index channel = 0; channel < 4; ++channel) {
            const auto alone = decomposeHankel(
                inputOf(series.row(channel), ResponseTreatment::Impulse, 10.0), {});
            QVERIFY(distance(realizedPoles(*alone, 4), truth) < 1e-6);
        }
    }

    void randomSystems_areRealizedExactly()
    {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const System system = randomSystem(3, seed);
            const Eigen::MatrixXd y = markovParameters(system, 120);
            const auto hankel
                = decomposeHankel(inputOf(y, ResponseTreatment::StepAsImpulse, 1.0), {});
            QVERIFY(distance(realizedPoles(*hankel, 6), eigenvalues(system.A)) < 1e-7);
            const Eigen::VectorXd again = impulseResponse(thesisRealization(*hankel, 6, 1.0), 121);
            QVERIFY2((again.tail(120) - y.row(0).transpose()).norm() < 1e-9 * y.norm(),
                qPrintable(QString::number((again.tail(120) - y.row(0).transpose()).norm())));
        }
    }

    void longRecord_isRealizedByLanczosAsWell()
    {
        const System system = randomSystem(3, 5);
        const Eigen::MatrixXd y = markovParameters(system, 1500);
        RealizationSettings settings;
        settings.maxOrder = 20;
        const auto hankel
            = decomposeHankel(inputOf(y, ResponseTreatment::StepAsImpulse, 1.0), settings);
        QCOMPARE(hankel->method, std::string("lanczos"));
        QCOMPARE(hankel->converged, Index(20));
        QVERIFY(distance(realizedPoles(*hankel, 6), eigenvalues(system.A)) < 1e-7);
        const Eigen::VectorXd again = impulseResponse(thesisRealization(*hankel, 6, 1.0), 1501);
        QVERIFY((again.tail(1500) - y.row(0).transpose()).norm() < 1e-8 * y.norm());
    }
};

DYNCAL_TEST(TestRealizationOracles)
#include "tst_realization_oracles.moc"
