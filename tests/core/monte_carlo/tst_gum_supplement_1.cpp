// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The examples of JCGM 101 (GUM, supplement 1), clause 9, whose numbers are printed there.

#include "core/base/propagation.h"
#include "core/monte_carlo/gum_validation.h"
#include "core/monte_carlo/source_draws.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace dyncal;

namespace {

constexpr Index kTrials = 200000;
using Function = std::function<double(const Eigen::VectorXd &)>;

struct Both
{
    DrawnQuantity drawn;
    GumValidation gum;
    double value = 0.0;
};

Eigen::VectorXd trialsOf(const std::vector<UncertainInput> &inputs, const Function &f)
{
    SourceDraws sources;
    std::vector<DrawnInput> drawn;
    for (const UncertainInput &input : inputs)
        drawn.push_back({input, sources.add(input)});
    Eigen::VectorXd y(kTrials), x(std::ssize(inputs));
    for (Index trial = 0; trial < kTrials; ++trial) {
        const Eigen::VectorXd p = sources.probabilities(1, trial);
        for (std::size_t i = 0; i < drawn.size(); ++i)
            x[static_cast<Index>(i)] = drawn[i].value(p);
        y[trial] = f(x);
    }
    return y;
}

Both propagated(const std::vector<UncertainInput> &inputs, const Function &f)
{
    const auto gum = propagateGum(inputs, [&](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
        return Eigen::VectorXd::Constant(1, f(x));
    });
    Both both;
    both.value = gum->value[0];
    both.drawn = drawnQuantity(trialsOf(inputs, f), both.value, 0.95);
    both.gum = validateGum(both.value, gum->u[0], gum->dof[0], 0.95, both.drawn);
    return both;
}

UncertainInput rectangle(const char *name, double low, double high)
{
    return {
        name, 0.5 * (low + high), 0.5 * (high - low) / std::sqrt(3.0), Distribution::Rectangular};
}

bool isAbout(double found, double printed, double within)
{
    if (std::abs(found - printed) <= within)
        return true;
    qWarning("found %.6g, printed %.6g", found, printed);
    return false;
}

double sum(const Eigen::VectorXd &x)
{
    return x.sum();
}

std::vector<UncertainInput> fourInputs(Distribution distribution, double last)
{
    std::vector<UncertainInput> inputs;
    for (const char *name : {"x1", "x2", "x3", "x4"})
        inputs.push_back({name, 0.0, 1.0, distribution});
    inputs.back().u = last;
    return inputs;
}

/// 9.3.1.3, in mg; densities in kg/m^3.
std::vector<UncertainInput> massInputs()
{
    return {{"m_rc", 100000.0, 0.050}, {"dm_rc", 1.234, 0.020}, rectangle("rho_a", 1.10, 1.30),
        rectangle("rho_w", 7000.0, 9000.0), rectangle("rho_r", 7950.0, 8050.0)};
}

double massDifference(const Eigen::VectorXd &x)
{
    return (x[0] + x[1]) * (1.0 + (x[2] - 1.2) * (1.0 / x[3] - 1.0 / x[4])) - 100000.0;
}

double comparisonLoss(const Eigen::VectorXd &x)
{
    return x.squaredNorm();
}

std::vector<UncertainInput> lossInputs(double x1)
{
    return {{"x1", x1, 0.005}, {"x2", 0.0, 0.005}};
}

} // namespace

class TestGumSupplement1 : public QObject
{
    Q_OBJECT

private slots:
    /// 9.2.2: normal inputs, both [-3.92, 3.92].
    void additiveNormal_isValidated()
    {
        const Both both = propagated(fourInputs(Distribution::Normal, 1.0), sum);
        QVERIFY(isAbout(both.drawn.u, 2.00, 0.01) && isAbout(both.drawn.low, -3.92, 0.03));
        QVERIFY(isAbout(both.gum.high, 3.92, 0.005) && both.gum.validated);
        QCOMPARE(sizeOfGum(both.gum, both.drawn), 0);
    }

    /// 9.2.3: rectangles of the same u, Monte Carlo [-3.88, 3.88].
    void additiveRectangles_areValidated()
    {
        const Both both = propagated(fourInputs(Distribution::Rectangular, 1.0), sum);
        QVERIFY(isAbout(both.drawn.low, -3.88, 0.02) && isAbout(both.drawn.high, 3.88, 0.02));
        QVERIFY(isAbout(both.gum.high, 3.92, 0.005) && both.gum.validated);
    }

    /// 9.2.4: one of them ten times as wide, Monte Carlo [-17.0, 17.0], the law [-19.9, 19.9].
    void oneWideRectangle_isNotValidated()
    {
        const Both both = propagated(fourInputs(Distribution::Rectangular, 10.0), sum);
        QVERIFY(isAbout(both.drawn.u, 10.1, 0.1) && isAbout(both.drawn.high, 17.0, 0.06));
        QVERIFY(isAbout(both.gum.high, 19.9, 0.05));
        QVERIFY(isAbout(both.gum.d_high, 2.9, 0.1));
        QVERIFY(!both.gum.validated);
        QCOMPARE(sizeOfGum(both.gum, both.drawn), 1); // the law gives too much
    }

    /// 9.3: u 0.0754 mg and [1.0834, 1.3825] mg; first order 0.0539 and [1.1285, 1.3395].
    void massCalibration_isNotValidatedToFirstOrder()
    {
        const Both both = propagated(massInputs(), massDifference);
        QVERIFY(isAbout(both.drawn.mean, 1.2341, 0.0006));
        QVERIFY(isAbout(both.drawn.u, 0.0754, 0.0005));
        QVERIFY(isAbout(both.drawn.low, 1.0834, 0.002) && isAbout(both.drawn.high, 1.3825, 0.002));
        QVERIFY(isAbout(both.gum.u, 0.0539, 0.0002));
        QVERIFY(isAbout(both.gum.low, 1.1285, 0.0005) && isAbout(both.gum.high, 1.3395, 0.0005));
        QVERIFY(!both.gum.validated);
        QCOMPARE(sizeOfGum(both.gum, both.drawn), -1); // and gives too little
    }

    /// 9.4.2.2 and 9.4.2.3, in 1e-6: the shortest intervals are printed.
    void comparisonLoss_isToldNearZero()
    {
        const Both zero = propagated(lossInputs(0.0), comparisonLoss);
        QVERIFY(
            isAbout(1e6 * zero.drawn.mean, 50.0, 0.4) && isAbout(1e6 * zero.drawn.u, 50.0, 0.6));
        QVERIFY(isAbout(1e6 * zero.drawn.shortestLow, 0.0, 0.1));
        QVERIFY(isAbout(1e6 * zero.drawn.shortestHigh, 150.0, 2.0));
        QVERIFY(zero.gum.u < 1e-12 && !zero.gum.validated);
        QCOMPARE(sizeOfGum(zero.gum, zero.drawn), -1);
        const Both small = propagated(lossInputs(0.010), comparisonLoss);
        QVERIFY(isAbout(1e6 * small.drawn.mean, 150.0, 1.0));
        QVERIFY(isAbout(1e6 * small.drawn.u, 112.0, 1.0));
        QVERIFY(isAbout(1e6 * small.drawn.shortestHigh, 367.0, 5.0));
        QVERIFY(
            isAbout(1e6 * small.gum.low, -96.0, 0.5) && isAbout(1e6 * small.gum.high, 296.0, 0.5));
        QVERIFY(!small.gum.validated);
    }

    void comparisonLoss_isNearlyLinearFarFromZero()
    {
        const Both large = propagated(lossInputs(0.050), comparisonLoss);
        QVERIFY(isAbout(1e6 * large.drawn.u, 502.0, 4.0));
        QVERIFY(isAbout(1e6 * large.drawn.shortestLow, 1590.0, 30.0));
        QVERIFY(isAbout(1e6 * large.gum.low, 1520.0, 1.0)
            && isAbout(1e6 * large.gum.high, 3480.0, 1.0));
    }

    /// Three readings: k = 2 holds too little, Student's factor is right.
    void threeReadings_needStudentsFactor()
    {
        const UncertainInput mean{"mean", 0.0, 1.0, Distribution::Normal, 2.0};
        const Both both = propagated({mean}, sum);
        QVERIFY(isAbout(both.drawn.high, 4.303, 0.08) && both.gum.validated);
        const GumValidation withTwo
            = validateGum(0.0, 1.0, std::numeric_limits<double>::infinity(), 0.95, both.drawn);
        QVERIFY(!withTwo.validated);
        QCOMPARE(sizeOfGum(withTwo, both.drawn), -1);
    }
};

DYNCAL_TEST(TestGumSupplement1)
#include "tst_gum_supplement_1.moc"
