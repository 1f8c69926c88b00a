// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The second-order sensor of several records as one problem of least squares: its cost written out
// over the samples, its equations as slopes of that cost.

#include "core/realization/second_order/second_order_problem.h"
#include "tests/support/model_inputs.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace dyncal;
using testing::isNear;

namespace {

using Complex = std::complex<double>;

constexpr double kRate_Hz = 1e6, kUnit_s = 1e-5;
constexpr double kOmega_rad_s = 2.0 * std::numbers::pi * 30e3;
constexpr Index kSamples = 300;

/// Two records at unlike rates and weights, the second with a mode of the tube.
std::vector<RefinementRecord> records(double zeta, double noise)
{
    testing::Noise source(3);
    std::vector<RefinementRecord> list(2);
    for (std::size_t r = 0; r < list.size(); ++r) {
        list[r].rate_Hz = r == 0 ? kRate_Hz : 0.5 * kRate_Hz;
        list[r].weight = r == 0 ? 1.0 : 3.0;
        const double height = r == 0 ? 1.0 : -2.5;
        list[r].y = height
                * testing::sampledStep(
                    kOmega_rad_s / (2.0 * std::numbers::pi), zeta, list[r].rate_Hz, kSamples, 0.4)
            + source.series(kSamples, noise);
    }
    NuisanceTerm term;
    term.startsWithStep = false;
    term.pole_rad_s = {-1e3, 5e4};
    list[1].nuisance = {term};
    return list;
}

/// The sensor's truth as parameters; the mode has no amplitude.
Eigen::VectorXd thetaOf(const SecondOrderProblem &problem, double zeta)
{
    Eigen::VectorXd theta = Eigen::VectorXd::Zero(problem.parameters());
    for (std::size_t r = 0; r < problem.records().size(); ++r) {
        SecondOrderStep step = problem.step(theta, r);
        step.logOmega = std::log(kOmega_rad_s * kUnit_s);
        step.logZeta = std::log(zeta);
        if (step.drift)
            step.drift = {-0.02, r == 0 ? 0.05 : -0.03};
        step.plateau = r == 0 ? 1.0 : -2.5;
        step.onset = -0.4 / problem.records()[r].rate_Hz / kUnit_s;
        for (SecondOrderStep::Mode &mode : step.modes)
            mode = {Complex(-1e3, 5e4) * kUnit_s, 0.0, mode.startsWithStep};
        problem.setStep(step, r, theta);
    }
    return theta;
}

/// The records' squares of what the sums of exponentials leave, one sample after the other.
double costOverSamples(const SecondOrderProblem &problem, const Eigen::VectorXd &theta)
{
    const Refinement fit = problem.asExponentials(theta);
    double cost = 0.0;
    for (std::size_t r = 0; r < fit.records.size(); ++r) {
        const RefinementRecord &record = problem.records()[r];
        for (Index k = 0; k < record.y.size(); ++k) {
            const double t_s = static_cast<double>(k) / record.rate_Hz;
            double value = fit.records[r].value(t_s);
            for (const NuisanceTerm &term : fit.nuisance[r])
                value += term.value(t_s);
            cost += std::pow(record.weight * (record.y[k] - value), 2.0);
        }
    }
    return cost;
}

/// Parameters of asExponentials() in the order of derivatives().
Eigen::VectorXd exponentialParameters(const Refinement &fit)
{
    std::vector<double> values;
    const auto addPoleLike = [&](const auto &list, double share) {
        for (Index i = 0; i < std::ssize(list); ++i) {
            const Complex s = fit.poles_rad_s[static_cast<std::size_t>(i)];
            if (s.imag() < 0.0)
                continue;
            const Complex value = list[static_cast<std::size_t>(i)];
            values.push_back(s.imag() > 0.0 ? share * value.real() : value.real());
            if (s.imag() > 0.0)
                values.push_back(share * value.imag());
        }
    };
    addPoleLike(fit.poles_rad_s, 1.0);
    for (std::size_t r = 0; r < fit.records.size(); ++r) {
        const std::vector<Complex> gains(
            fit.records[r].amplitudes.begin(), fit.records[r].amplitudes.end());
        addPoleLike(gains, 2.0); // Re(g e^(s t)) of a pair
        values.push_back(fit.records[r].constant);
        for (const NuisanceTerm &term : fit.nuisance[r])
            values.insert(values.end(),
                {term.pole_rad_s.real(), term.pole_rad_s.imag(), term.amplitude.real(),
                    term.amplitude.imag()});
    }
    return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

} // namespace

class TestSecondOrderProblem : public QObject
{
    Q_OBJECT

private:
    static void sensors()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<bool>("drifts");
        for (const double zeta : {0.05, 0.8, 1.4})
            for (const bool drifts : {false, true})
                QTest::addRow("zeta %g%s", zeta, drifts ? ", a drift" : "") << zeta << drifts;
    }

private slots:
    /// At the truth of records without noise nothing is left.
    void truth_hasNoCost()
    {
        for (const double zeta : {0.05, 0.8}) {
            const std::vector<RefinementRecord> list = records(zeta, 0.0);
            const SecondOrderProblem problem(list, kUnit_s, 0.0, false);
            QVERIFY(problem.normalEquations(thetaOf(problem, zeta)).cost < 1e-20);
        }
    }

    /// The cost of the equations is the sum over the samples that the poles and amplitudes give.
    void cost_isTheSumOverTheSamples_data() { sensors(); }
    void cost_isTheSumOverTheSamples()
    {
        QFETCH(double, zeta);
        QFETCH(bool, drifts);
        const std::vector<RefinementRecord> list = records(0.6, 0.01);
        const SecondOrderProblem problem(list, kUnit_s, 0.0, drifts);
        Eigen::VectorXd theta = thetaOf(problem, zeta);
        theta.tail(2).setConstant(0.02); // the mode's amplitude
        const double cost = problem.normalEquations(theta).cost;
        QVERIFY(isNear(costOverSamples(problem, theta), cost, 1e-9));
    }

    /// The gradient is minus half of the cost's slope, by differences of the sum above.
    void gradient_isMinusHalfOfTheSlope_data() { sensors(); }
    void gradient_isMinusHalfOfTheSlope()
    {
        QFETCH(double, zeta);
        QFETCH(bool, drifts);
        const std::vector<RefinementRecord> list = records(0.6, 0.01);
        const SecondOrderProblem problem(list, kUnit_s, 0.0, drifts);
        Eigen::VectorXd theta = thetaOf(problem, zeta);
        theta.tail(2) << 0.02, -0.03;
        const RegressionEquations equations = problem.normalEquations(theta);
        for (Index i = 0; i < theta.size(); ++i) {
            constexpr double kStep = 1e-5;
            const Eigen::VectorXd change = kStep * Eigen::VectorXd::Unit(theta.size(), i);
            const double slope = (costOverSamples(problem, theta + change)
                                     - costOverSamples(problem, theta - change))
                / (2.0 * kStep);
            const double scale = std::sqrt(equations.cost * equations.matrix(i, i));
            QVERIFY2(std::abs(slope + 2.0 * equations.gradient[i]) < 1e-5 * scale + 1e-6,
                qPrintable(QString::number(i)));
        }
    }

    /// d (poles and amplitudes) / d theta, by differences.
    void derivatives_areThoseOfPolesAndAmplitudes_data() { sensors(); }
    void derivatives_areThoseOfPolesAndAmplitudes()
    {
        QFETCH(double, zeta);
        QFETCH(bool, drifts);
        const std::vector<RefinementRecord> list = records(0.6, 0.01);
        const SecondOrderProblem problem(list, kUnit_s, 0.0, drifts);
        Eigen::VectorXd theta = thetaOf(problem, zeta);
        theta.tail(2) << 0.02, -0.03;
        const Eigen::MatrixXd J = problem.derivatives(theta, problem.asExponentials(theta));
        for (Index i = 0; i < theta.size(); ++i) {
            constexpr double kStep = 1e-5;
            const Eigen::VectorXd change = kStep * Eigen::VectorXd::Unit(theta.size(), i);
            const Eigen::VectorXd slope
                = (exponentialParameters(problem.asExponentials(theta + change))
                      - exponentialParameters(problem.asExponentials(theta - change)))
                / (2.0 * kStep);
            QCOMPARE(slope.size(), J.rows());
            for (Index row = 0; row < J.rows(); ++row)
                QVERIFY(std::abs(slope[row] - J(row, i))
                    < 1e-6 * (1e-3 * J.row(row).norm() + std::abs(J(row, i))) + 1e-7);
        }
    }

    /// A record's own parameters are its own; those shared are seen by both.
    void parameters_ofOneRecord_leaveTheOthers()
    {
        const std::vector<RefinementRecord> list = records(0.6, 0.0);
        const SecondOrderProblem problem(list, kUnit_s, 0.0, true);
        QCOMPARE(problem.parameters(), Index(3 + 3 + 3 + 4));
        QCOMPARE(problem.plateauAt(0), Index(3));
        QCOMPARE(problem.plateauAt(1), Index(6));
        QCOMPARE(problem.samples(), 2 * kSamples);
        Eigen::VectorXd theta = thetaOf(problem, 0.6);
        const Eigen::VectorXd before = theta;
        SecondOrderStep second = problem.step(theta, 1);
        second.plateau = 7.0;
        second.onset = 0.5;
        second.modes[0].amplitude = {1.0, 2.0};
        problem.setStep(second, 1, theta);
        QCOMPARE(Eigen::VectorXd(theta.head(6)), Eigen::VectorXd(before.head(6)));
        QCOMPARE(problem.step(theta, 1).plateau, 7.0);
        QCOMPARE(problem.step(theta, 0).plateau, 1.0);
        second.logZeta = 0.1;
        problem.setStep(second, 1, theta);
        QCOMPARE(problem.step(theta, 0).logZeta, 0.1);
    }

    /// Weights are squared, and samples left out take no part.
    void weightsAndRanges_countAsTheySay()
    {
        std::vector<RefinementRecord> list = records(0.6, 0.01);
        list.pop_back();
        const SecondOrderProblem whole(list, kUnit_s, 0.0, false);
        const Eigen::VectorXd theta = thetaOf(whole, 0.6);
        const double cost = whole.normalEquations(theta).cost;
        std::vector<RefinementRecord> heavy = list;
        heavy[0].weight = 5.0;
        const SecondOrderProblem weighted(heavy, kUnit_s, 0.0, false);
        QVERIFY(isNear(weighted.normalEquations(theta).cost, 25.0 * cost, 1e-12));
        double parts = 0.0;
        for (const SampleRange &range : {SampleRange{0, 130}, SampleRange{130, kSamples}}) {
            std::vector<RefinementRecord> part = list;
            part[0].used = {range};
            const SecondOrderProblem one(part, kUnit_s, 0.0, false);
            QCOMPARE(one.samples(), range.end - range.begin);
            parts += one.normalEquations(theta).cost;
        }
        QVERIFY(isNear(parts, cost, 1e-9));
    }
};

DYNCAL_TEST(TestSecondOrderProblem)
#include "tst_second_order_problem.moc"
