// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The sampled model against scipy: zero-order hold of the sensor's transfer function, its zeros as
// generalised eigenvalues, its frequency response by solving; and the properties that define them.

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/model_fit.h"
#include "core/realization/model/sensor_model.h"
#include "tests/support/model_inputs.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

// zeros "n A B C D" ...: finite generalised eigenvalues of ([A B; C D], [I 0; 0 0]).
// zoh f0 zeta f1 zeta1 dt count: impulse response of the sampled sensor. Lines: value, group.
const char *const kOracle = R"PY(
import sys
import numpy as np
import scipy.linalg, scipy.signal
what = sys.argv[1]
if what == 'zeros':
    for model, text in enumerate(sys.argv[2:]):
        v = np.array([float(x) for x in text.split()])
        n = int(v[0])
        v = v[1:]
        A, B = v[:n * n].reshape(n, n), v[n * n:n * n + n].reshape(n, 1)
        C, D = v[n * n + n:n * n + 2 * n].reshape(1, n), v[-1].reshape(1, 1)
        M = np.block([[A, B], [C, D]])
        N = scipy.linalg.block_diag(np.eye(n), np.zeros((1, 1)))
        for z in scipy.linalg.eigvals(M, N):
            if np.isfinite(z) and abs(z) < 1e4:
                print(repr(z.real), repr(z.imag), model)
else:
    f0, z0, f1, z1, dt = (float(x) for x in sys.argv[2:7])
    w0, w1 = 2 * np.pi * f0, 2 * np.pi * f1
    d0, d1 = np.array([1, 2 * z0 * w0, w0 * w0]), np.array([1, 2 * z1 * w1, w1 * w1])
    num = 0.7 * w0 * w0 * d1 + 0.3 * w1 * w1 * d0
    den = np.polymul(d0, d1)
    A, B, C, D = scipy.signal.tf2ss(num, den)
    A, B, C, D, _ = scipy.signal.cont2discrete((A, B, C, D), dt, 'zoh')
    _, (h,) = scipy.signal.dimpulse((A, B, C, D, dt), n=int(sys.argv[7]))
    for y in h[:, 0]:
        print(repr(float(y)), 0, 0)
)PY";

/// By group.
std::vector<std::vector<Complex>> answer(const QStringList &arguments, std::size_t groups)
{
    const testing::PythonAnswer said = testing::python(QStringList{"-c", kOracle} + arguments);
    if (!said.ran)
        qWarning("%s", said.err.constData());
    std::vector<std::vector<Complex>> values(said.ran ? groups : 0);
    for (const QByteArray &line : said.out.split('\n')) {
        const auto parts = line.split(' ');
        if (parts.size() == 3)
            values.at(static_cast<std::size_t>(parts[2].toInt()))
                .emplace_back(parts[0].toDouble(), parts[1].toDouble());
    }
    return values;
}

QString exact(double value)
{
    return QString::number(value, 'g', 17);
}

QString textOf(const StateSpaceModel &model)
{
    const Index n = model.order();
    QStringList numbers{QString::number(n)};
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            numbers += exact(model.A(i, j));
    for (Index i = 0; i < n; ++i)
        numbers += exact(model.B(i, 0));
    for (Index i = 0; i < n; ++i)
        numbers += exact(model.C(0, i));
    numbers += exact(model.D(0, 0));
    return numbers.join(' ');
}

Complex responseAt(const StateSpaceModel &model, Complex z)
{
    const Index n = model.order();
    const Eigen::MatrixXcd left = z * Eigen::MatrixXcd::Identity(n, n) - model.A.cast<Complex>();
    return (model.C.cast<Complex>() * left.partialPivLu().solve(model.B.cast<Complex>()))(0, 0)
        + model.D(0, 0);
}

/// Farthest that one of the first is from the nearest of the second.
double farthest(const std::vector<Complex> &from, const std::vector<Complex> &to)
{
    double worst = 0.0;
    for (const Complex &a : from) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Complex &b : to)
            nearest = std::min(nearest, std::abs(a - b) / (1.0 + std::abs(b)));
        worst = std::max(worst, nearest);
    }
    return worst;
}

/// Pairs and a real pole, residues and feedthrough as asked.
StateSpaceModel randomModal(Index pairs, bool withReal, double feedthrough, std::uint64_t seed)
{
    testing::Noise noise(seed);
    std::vector<Complex> poles;
    Eigen::VectorXcd residues(2 * pairs + (withReal ? 1 : 0));
    for (Index i = 0; i < pairs; ++i) {
        const double radius = 0.6 + 0.35 / (1.0 + std::exp(noise.next()));
        poles.push_back(std::polar(radius, 0.3 + 2.5 * static_cast<double>(i) / 3.0));
        poles.push_back(std::conj(poles.back()));
        residues[2 * i] = {noise.next(), noise.next()};
        residues[2 * i + 1] = std::conj(residues[2 * i]);
    }
    if (withReal) {
        poles.emplace_back(0.4);
        residues[2 * pairs] = -1.0 + 0.3 * noise.next();
    }
    return modalStateSpace(poles, residues, feedthrough, 1e-6);
}

} // namespace

class TestStateSpace : public QObject
{
    Q_OBJECT

private slots:
    void zeros_areTheFiniteGeneralisedEigenvalues()
    {
        if (!testing::hasNumericalPython())
            QSKIP("numpy and scipy are missing: not compared with them");
        std::vector<StateSpaceModel> models;
        QStringList arguments{"zeros"};
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            for (const double feedthrough : {0.0, 0.5, -3.0}) {
                models.push_back(randomModal(
                    1 + static_cast<Index>(seed % 3), seed % 2 == 0, feedthrough, seed));
                arguments += textOf(models.back());
            }
        }
        const auto truths = answer(arguments, models.size());
        QCOMPARE(truths.size(), models.size());
        constexpr double kOfEigenvalues = 1e-7;
        for (std::size_t i = 0; i < models.size(); ++i) {
            const std::vector<Complex> zeros = transmissionZeros(models[i]);
            QCOMPARE(zeros.size(), truths[i].size());
            QVERIFY(farthest(zeros, truths[i]) < kOfEigenvalues);
            QVERIFY(farthest(truths[i], zeros) < kOfEigenvalues);
            for (const Complex &z : zeros)
                QVERIFY(std::abs(responseAt(models[i], z))
                    < 1e-6 * std::abs(responseAt(models[i], 1.5 * z + Complex(0.3, 0.2))));
        }
    }

    void zeros_behindADelay_areStillThere()
    {
        // Two samples of delay in front: h = 0, 0, 0, CB ...: the finite zeros are those without.
        const StateSpaceModel plain = randomModal(2, true, 0.0, 9);
        const Index n = plain.order();
        for (const Index delay : {1, 2, 3}) {
            StateSpaceModel late;
            late.A = Eigen::MatrixXd::Zero(n + delay, n + delay);
            late.A.topLeftCorner(n, n) = plain.A;
            late.A.block(0, n, n, 1) = plain.B; // fed by the last of the chain
            for (Index i = 1; i < delay; ++i)
                late.A(n + i - 1, n + i) = 1.0;
            late.B = Eigen::MatrixXd::Zero(n + delay, 1);
            late.B(n + delay - 1, 0) = 1.0;
            late.C = Eigen::MatrixXd::Zero(1, n + delay);
            late.C.leftCols(n) = plain.C;
            late.D = Eigen::MatrixXd::Zero(1, 1);
            const Eigen::VectorXd h = impulseResponse(late, 30);
            QVERIFY((h.tail(30 - delay) - impulseResponse(plain, 30 - delay)).norm() < 1e-12);
            const std::vector<Complex> expected = transmissionZeros(plain);
            const std::vector<Complex> found = transmissionZeros(late);
            QCOMPARE(found.size(), expected.size());
            QVERIFY(farthest(found, expected) < 1e-6);
        }
    }

    void zeros_scaleOfTheOutput_changesNone()
    {
        for (const double feedthrough : {0.0, 0.5}) {
            StateSpaceModel model = randomModal(2, true, feedthrough, 4);
            const std::vector<Complex> zeros = transmissionZeros(model);
            for (const double factor : {1e-12, -1e9}) {
                StateSpaceModel scaled = model;
                scaled.C *= factor;
                scaled.D *= factor;
                const std::vector<Complex> again = transmissionZeros(scaled);
                QCOMPARE(again.size(), zeros.size());
                QVERIFY(farthest(again, zeros) < 1e-9);
            }
        }
        QVERIFY(transmissionZeros({}).empty());
        const StateSpaceModel silent = modalStateSpace({0.5}, Eigen::VectorXcd::Zero(1), 0.0, 1.0);
        QVERIFY(transmissionZeros(silent).empty()); // nothing comes out: no zero either
    }

    void modalForm_isTheSumOfItsParts()
    {
        const std::vector<Complex> poles{
            {0.7, 0.5}, {0.7, -0.5}, {-0.3, 0.0}, {0.2, 0.9}, {0.2, -0.9}, {0.0, 0.0}, {1.2, 0.0}};
        Eigen::VectorXcd residues(7);
        residues << Complex(1.0, -2.0), Complex(1.0, 2.0), 0.4, Complex(0.0, 1e-7),
            Complex(0.0, -1e-7), -2.0, 0.0;
        const StateSpaceModel model = modalStateSpace(poles, residues, 0.25, 1e-3);
        QCOMPARE(model.sampleInterval_s, 1e-3);
        for (const Complex z : {Complex(2.0, 0.0), Complex(0.1, 1.3), Complex(-0.9, 0.6)}) {
            Complex truth = 0.25;
            for (std::size_t i = 0; i < poles.size(); ++i)
                truth += residues[static_cast<Index>(i)] / (z - poles[i]);
            QVERIFY(std::abs(responseAt(model, z) - truth) < 1e-13 * (1.0 + std::abs(truth)));
        }
        // h_k = sum r p^(k-1), directly.
        const Eigen::VectorXd h = impulseResponse(model, 12);
        QCOMPARE(h[0], 0.25);
        for (Index k = 1; k < 12; ++k) {
            Complex sum = 0.0;
            for (std::size_t i = 0; i < poles.size(); ++i)
                sum += residues[static_cast<Index>(i)]
                    * (k == 1 ? 1.0 : std::pow(poles[i], static_cast<double>(k - 1)));
            QVERIFY(std::abs(h[k] - sum.real()) < 1e-12);
        }
        QCOMPARE(impulseResponse(model, 0).size(), Index(0));
        QCOMPARE(impulseResponse(model, 1)[0], 0.25);
    }

    void realizedSensor_isItsZeroOrderHold()
    {
        if (!testing::hasNumericalPython())
            QSKIP("numpy and scipy are missing: not compared with them");
        // Two modes side by side; onset on a sample. Nothing of the way from the record to the
        // model is shared with scipy's.
        const double dt_s = 1e-6;
        const auto said = answer({"zoh", "40e3", "0.04", "130e3", "0.1", "1e-6", "300"}, 1);
        QCOMPARE(said.size(), std::size_t(1));
        const std::vector<Complex> &h = said[0];
        QCOMPARE(h.size(), std::size_t(300));
        Eigen::VectorXd y(300);
        double sum = 0.0;
        for (Index k = 0; k < 300; ++k)
            y[k] = sum += h[static_cast<std::size_t>(k)].real(); // step = sum of impulses
        const ModelInput input = testing::makeInput(
            ResponseTreatment::StepDeflated, 1.0 / dt_s, {testing::makeSeries(1, y, 1.0 / dt_s)});
        const auto hankel = decomposeHankel(input, {});
        for (const bool refine : {true, false}) {
            RealizationSettings settings;
            settings.refine = refine;
            const SensorModel model = fitModel(input, *hankel, 4, settings, {}).value();
            constexpr double kOfRealization = 1e-6;
            const Eigen::VectorXd again = impulseResponse(model.stateSpace, 300);
            QVERIFY(std::abs(model.poles[0].frequency_Hz / 40e3 - 1.0) < kOfRealization);
            QVERIFY(std::abs(model.poles[2].frequency_Hz / 130e3 - 1.0) < kOfRealization);
            QVERIFY(std::abs(model.poles[0].dampingRatio / 0.04 - 1.0) < kOfRealization);
            QVERIFY(std::abs(model.poles[2].dampingRatio / 0.1 - 1.0) < kOfRealization);
            // At zero frequency the sampled model is the plateau.
            QVERIFY(std::abs(responseAt(model.stateSpace, 1.0) - 1.0) < kOfRealization);
            for (Index k = 0; k < 300; ++k)
                QVERIFY(
                    std::abs(again[k] - h[static_cast<std::size_t>(k)].real()) < kOfRealization);
        }
    }

    void thesisListing_reproducesWhatItWasGiven()
    {
        // Ho and Kalman: with all states the listing's model gives every sample back.
        testing::Noise noise(2);
        const Eigen::VectorXd y = noise.series(21, 1.0);
        const ModelInput input = testing::makeInput(
            ResponseTreatment::StepAsImpulse, 1e6, {testing::makeSeries(1, y, 1e6)});
        RealizationSettings settings;
        settings.rows = Index(10);
        const auto hankel = decomposeHankel(input, settings);
        const Index n = largestOrder(*hankel);
        QCOMPARE(n, Index(9)); // a row is lost to the shift
        const StateSpaceModel model = thesisRealization(*hankel, n, 1e-6);
        QCOMPARE(model.order(), n);
        QCOMPARE(model.D(0, 0), 0.0);
        QCOMPARE(realizedPoles(*hankel, n).size(), std::size_t(n));
        // The poles are those of its A, paired.
        std::vector<Complex> own;
        for (const Complex &z : realizedPoles(*hankel, n))
            own.push_back(z);
        Complex trace = 0.0;
        for (const Complex &z : own)
            trace += z;
        QVERIFY(std::abs(trace - model.A.trace()) < 1e-9);
    }

    void poles_comeInExactPairs_atEveryOrder()
    {
        testing::Noise noise(5);
        const Eigen::VectorXd y
            = testing::sampledStep(90e3, 0.1, 1e6, 160) + noise.series(160, 0.02);
        for (const auto treatment : {ResponseTreatment::StepDeflated,
                 ResponseTreatment::StepAsImpulse, ResponseTreatment::Differenced}) {
            const ModelInput input
                = testing::makeInput(treatment, 1e6, {testing::makeSeries(1, y, 1e6)});
            const auto hankel = decomposeHankel(input, {});
            for (Index n = 1; n <= 30; ++n) {
                const std::vector<Complex> poles = realizedPoles(*hankel, n);
                QCOMPARE(std::ssize(poles), n);
                for (std::size_t i = 0; i < poles.size(); ++i) {
                    QVERIFY(std::isfinite(std::abs(poles[i])));
                    if (poles[i].imag() == 0.0)
                        continue;
                    QVERIFY(poles[i].imag() > 0.0 && i + 1 < poles.size());
                    QCOMPARE(poles[i + 1], std::conj(poles[i]));
                    ++i;
                }
            }
        }
    }

    void poles_ofTheRecordScaled_areTheSame()
    {
        testing::Noise noise(6);
        const Eigen::VectorXd y
            = testing::sampledStep(90e3, 0.1, 1e6, 160) + noise.series(160, 0.02);
        const auto polesOf = [](const Eigen::VectorXd &record) {
            const ModelInput input = testing::makeInput(
                ResponseTreatment::StepDeflated, 1e6, {testing::makeSeries(1, record, 1e6)});
            return realizedPoles(*decomposeHankel(input, {}), 6);
        };
        const std::vector<Complex> one = polesOf(y);
        for (const double factor : {1e-15, -2.0, 1e12})
            QVERIFY(farthest(polesOf(factor * y), one) < 1e-8);
        // A constant is what deflation takes out.
        QVERIFY(farthest(polesOf((y.array() + 7.0).matrix()), one) < 1e-8);
    }
};

DYNCAL_TEST(TestStateSpace)
#include "tst_state_space.moc"
