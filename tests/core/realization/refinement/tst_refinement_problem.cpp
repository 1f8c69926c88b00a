// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/refinement_problem.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;
constexpr double kRate_Hz = 1e6;
const Complex kPair(-6e3, 2e5);
const Complex kTube(-1e3, 4.3e4);
const std::vector<Complex> kRates{kPair, std::conj(kPair), {-4e4, 0.0}};

RefinementRecord noisyRecord(Index count, std::uint64_t seed, bool withTube)
{
    RefinementRecord record;
    record.rate_Hz = kRate_Hz;
    record.weight = 20.0 + static_cast<double>(seed);
    record.y = testing::Noise(seed).series(count, 0.05);
    for (Index k = 0; k < count; ++k) {
        const double t_s = static_cast<double>(k) / kRate_Hz;
        record.y[k] += 1.0 - (Complex(0.7, 0.1) * std::exp(kPair * t_s)).real();
    }
    if (withTube)
        record.nuisance.push_back({0, true, kTube, {}});
    return record;
}

/// Somewhere away from the minimum.
Eigen::VectorXd somewhere(const RefinementProblem &problem)
{
    Eigen::VectorXd theta = problem.start();
    problem.solveAmplitudes(theta);
    for (Index i = 0; i < theta.size(); ++i)
        theta[i] += 0.01 * std::cos(static_cast<double>(3 * i));
    return theta;
}

} // namespace

class TestRefinementProblem : public QObject
{
    Q_OBJECT

private slots:
    void layout_isPolesThenEveryRecordsOwn()
    {
        const std::vector<RefinementRecord> records{
            noisyRecord(50, 1, true), noisyRecord(40, 2, false)};
        const RefinementProblem problem(records, kRates, true);
        QCOMPARE(problem.poles(), Index(3));
        QCOMPARE(problem.isPair(), (std::vector<bool>{true, false}));
        QCOMPARE(problem.offset(0), Index(3));
        QCOMPARE(problem.nuisanceOffset(0, 0), Index(3 + 4));
        QCOMPARE(problem.offset(1), Index(3 + 4 + 4));
        QCOMPARE(problem.parameters(), Index(3 + 4 + 4 + 4));
        QCOMPARE(problem.samples(), Index(90));
        // Poles of order one, the fastest of size one.
        const Eigen::VectorXd start = problem.start();
        QCOMPARE(problem.unit_s(), 1.0 / std::abs(kPair));
        QCOMPARE(std::hypot(start[0], start[1]), 1.0);
        QCOMPARE(start[2], -4e4 * problem.unit_s());
        QCOMPARE(start[problem.nuisanceOffset(0, 0) + 1], kTube.imag() * problem.unit_s());
        QVERIFY(start.segment(3, 4).isZero(0.0));
    }

    void gradient_isThatOfTheCost()
    {
        std::vector<RefinementRecord> records{
            noisyRecord(300, 1, true), noisyRecord(200, 2, false)};
        records[1].used = {{0, 90}, {120, 200}};
        const RefinementProblem problem(records, kRates, true);
        const Eigen::VectorXd theta = somewhere(problem);
        const RegressionEquations equations = problem.equations(theta);
        for (Index i = 0; i < theta.size(); ++i) {
            constexpr double kStep = 1e-6;
            Eigen::VectorXd up = theta;
            Eigen::VectorXd down = theta;
            up[i] += kStep;
            down[i] -= kStep;
            const double slope
                = (problem.equations(up).cost - problem.equations(down).cost) / (2.0 * kStep);
            // cost = r^T r with r = y - model: its slope is -2 J^T r.
            QVERIFY2(std::abs(slope + 2.0 * equations.gradient[i]) < 1e-5 * (1.0 + std::abs(slope)),
                qPrintable(QString("%1: %2 %3").arg(i).arg(slope).arg(equations.gradient[i])));
        }
    }

    void cost_isTheWeightedSquareOfWhatTakesPart()
    {
        std::vector<RefinementRecord> records{noisyRecord(100, 3, false)};
        records[0].used = {{10, 20}, {50, 80}};
        const RefinementProblem problem(records, kRates, true);
        double expected = 0.0;
        for (const SampleRange &range : records[0].used)
            expected += records[0].y.segment(range.begin, range.size()).squaredNorm();
        expected *= records[0].weight * records[0].weight;
        const double found = problem.equations(problem.start()).cost; // all amplitudes are zero
        QVERIFY(std::abs(found - expected) < 1e-12 * expected);
        QCOMPARE(problem.samples(), Index(40));
    }

    void solvedAmplitudes_leaveNoGradientInThem()
    {
        const std::vector<RefinementRecord> records{
            noisyRecord(300, 1, true), noisyRecord(200, 2, false)};
        const RefinementProblem problem(records, kRates, true);
        Eigen::VectorXd theta = problem.start();
        problem.solveAmplitudes(theta);
        const RegressionEquations equations = problem.equations(theta);
        const Eigen::VectorXd size
            = equations.matrix.diagonal().cwiseSqrt() * std::sqrt(equations.cost);
        for (const std::size_t record : {std::size_t(0), std::size_t(1)}) {
            for (Index i = 0; i < 4; ++i) {
                const Index at = problem.offset(record) + i;
                QVERIFY(std::abs(equations.gradient[at]) < 1e-10 * size[at]);
            }
        }
        const Index tube = problem.nuisanceOffset(0, 0) + 2;
        QVERIFY(std::abs(equations.gradient[tube]) < 1e-10 * size[tube]);
        QVERIFY(std::abs(equations.gradient[tube + 1]) < 1e-10 * size[tube + 1]);
    }

    void nearStart_isDecayingAndTheSameOscillation()
    {
        const std::vector<RefinementRecord> records{noisyRecord(200, 1, true)};
        const RefinementProblem problem(records, kRates, true);
        const Eigen::VectorXd start = problem.start();
        QVERIFY(problem.isNearStart(start));
        const auto moved = [&](Index i, double factor) {
            Eigen::VectorXd theta = start;
            theta[i] *= factor;
            return problem.isNearStart(theta);
        };
        QVERIFY(moved(0, 5.0)); // damping is free
        QVERIFY(!moved(0, -1.0)); // growth is not
        QVERIFY(moved(1, 1.4) && !moved(1, 1.6) && moved(1, 0.7) && !moved(1, 0.6));
        QVERIFY(moved(2, 1.4) && !moved(2, 1.6) && !moved(2, -1.0));
        const Index tube = problem.nuisanceOffset(0, 0) + 1;
        QVERIFY(moved(tube, 1.4) && !moved(tube, 1.6) && !moved(tube, -1.0));
    }

    void slopesAndLevel_standForWhatHasNotEnded()
    {
        // Over 50 samples the real pole has two time constants, over 200 eight.
        const std::vector<RefinementRecord> records{noisyRecord(50, 1, true)};
        const RefinementProblem problem(records, kRates, true);
        QCOMPARE(problem.relaxing(), std::vector<Index>{2});
        QVERIFY(RefinementProblem(records, kRates, false).relaxing().empty());
        const std::vector<RefinementRecord> longer{noisyRecord(200, 1, true)};
        QVERIFY(RefinementProblem(longer, kRates, true).relaxing().empty());

        Eigen::VectorXd theta = somewhere(problem);
        const Eigen::VectorXd amplitudes = problem.amplitudes(theta);
        QCOMPARE(amplitudes[5] * theta[2], theta[5]);
        QVERIFY(std::abs(amplitudes[5] + amplitudes[6] - theta[6]) < 1e-12);

        // Its rate is free as long as it has not ended, and may pass 0 where it is nearly a ramp.
        const auto isNear = [&](double timeConstants) {
            theta = problem.start();
            theta[2] *= timeConstants / 2.0;
            return problem.isNearStart(theta);
        };
        QVERIFY(isNear(0.01) && isNear(-0.4) && isNear(2.9));
        QVERIFY(!isNear(-0.6) && !isNear(3.2));
        theta[2] = 0.0;
        problem.leaveZero(theta);
        QVERIFY(theta[2] != 0.0 && std::abs(theta[2]) < 2e-3 * std::abs(problem.start()[2]));
    }

    void gradient_isThatOfTheCost_throughRateZero_data()
    {
        QTest::addColumn<double>("timeConstants");
        QTest::newRow("unsettled") << 1.5;
        QTest::newRow("nearly a ramp") << 0.1;
        QTest::newRow("hardly to be told from a ramp") << 0.004;
        QTest::newRow("a ramp that grows") << -0.05;
    }
    void gradient_isThatOfTheCost_throughRateZero()
    {
        QFETCH(double, timeConstants);
        std::vector<RefinementRecord> records{
            noisyRecord(300, 1, true), noisyRecord(200, 2, false)};
        records[1].used = {{0, 90}, {120, 200}};
        std::vector<Complex> rates = kRates;
        rates[2] = -timeConstants * kRate_Hz / 300.0;
        const RefinementProblem problem(records, rates, true);
        Eigen::VectorXd theta = problem.start();
        problem.solveAmplitudes(theta);
        for (Index i = 3; i < theta.size(); ++i)
            theta[i] += 0.01 * std::abs(theta[i]) * std::cos(static_cast<double>(3 * i));
        const RegressionEquations equations = problem.equations(theta);
        for (Index i = 0; i < theta.size(); ++i) {
            // A thousandth of the way over which the cost changes by one.
            const double step = 1e-3 / std::sqrt(equations.matrix(i, i));
            Eigen::VectorXd up = theta;
            Eigen::VectorXd down = theta;
            up[i] += step;
            down[i] -= step;
            const double slope
                = (problem.equations(up).cost - problem.equations(down).cost) / (2.0 * step);
            QVERIFY2(std::abs(slope + 2.0 * equations.gradient[i])
                    < 1e-4 * (std::abs(slope) + 1e-2 / step),
                qPrintable(QString("%1: %2 %3").arg(i).arg(slope).arg(equations.gradient[i])));
        }
    }

    void nothingToFit_hasNoUnit()
    {
        const std::vector<RefinementRecord> records{noisyRecord(50, 1, false)};
        QCOMPARE(RefinementProblem(records, {}, true).unit_s(), 0.0);
    }

    void means_keepThePoles()
    {
        constexpr Index kFactor = 8;
        RefinementRecord record;
        record.rate_Hz = kRate_Hz;
        record.weight = 3.0;
        record.y.resize(1003);
        for (Index k = 0; k < record.y.size(); ++k)
            record.y[k] = std::exp(kPair * (static_cast<double>(k) / kRate_Hz)).real();
        const RefinementRecord means = averaged({record}, kFactor).front();
        QCOMPARE(means.y.size(), Index(125)); // the last three samples are left
        QCOMPARE(means.rate_Hz, kRate_Hz / 8.0);
        QCOMPARE(means.weight, 3.0 * std::sqrt(8.0));
        QVERIFY(means.used.empty());
        // The same exponential with the gain (q^8 - 1)/(8 (q - 1)).
        const Complex q = std::exp(kPair / kRate_Hz);
        const Complex gain = (std::pow(q, 8) - 1.0) / (8.0 * (q - 1.0));
        for (Index k = 0; k < means.y.size(); ++k) {
            const double t_s = static_cast<double>(k) / means.rate_Hz;
            QVERIFY(std::abs(means.y[k] - (gain * std::exp(kPair * t_s)).real()) < 1e-12);
        }
    }

    void means_ofSamplesLeftOut_takeNoPart()
    {
        RefinementRecord record;
        record.rate_Hz = kRate_Hz;
        record.y = Eigen::VectorXd::LinSpaced(100, 0.0, 99.0);
        record.used = {{3, 25}, {26, 29}, {40, 100}};
        const RefinementRecord means = averaged({record}, 10).front();
        QCOMPARE(std::ssize(means.used), std::ptrdiff_t(2));
        QCOMPARE(means.used[0].begin, Index(1));
        QCOMPARE(means.used[0].end, Index(2));
        QCOMPARE(means.used[1].begin, Index(4));
        QCOMPARE(means.used[1].end, Index(10));
        // No whole mean left is not the same as "all".
        record.used = {{3, 12}};
        const std::vector<RefinementRecord> none = averaged({record}, 10);
        QCOMPARE(RefinementProblem(none, kRates, true).samples(), Index(0));
    }
};

DYNCAL_TEST(TestRefinementProblem)
#include "tst_refinement_problem.moc"
