// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The known values of the self-test, found once more in another way: conservation laws by Newton's
// method, roots of the second-order response by bisection, Student's t by quadrature, spectra by
// long double, a singular value by the power method.

#include "core/selftest/second_order_truth.h"
#include "core/selftest/selftest.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

using namespace dyncal;

namespace {

using Function = std::function<double(double)>;

/// The expected value and tolerance of a check.
const CheckSpec &specOf(const std::string &name)
{
    static const std::vector<CheckSpec> all = allChecks();
    const auto found = std::ranges::find_if(
        all, [&](const CheckSpec &spec) { return english(spec.name) == name; });
    if (found == all.end())
        qFatal("no check %s", name.c_str());
    return *found;
}

/// Whether the value found here agrees within the check's own tolerance.
bool agrees(const std::string &name, double value)
{
    const CheckSpec &spec = specOf(name);
    const bool same = std::abs(spec.expected - value) <= spec.tolerance;
    if (!same)
        qWarning("%s: expected %.12g, here %.12g", name.c_str(), spec.expected, value);
    return same;
}

/// The first root of f from `from` on, f changing its sign within steps of `step`.
double firstRoot(const Function &f, double from, double step)
{
    double a = from;
    while ((f(a) < 0.0) == (f(a + step) < 0.0))
        a += step;
    double b = a + step;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (a + b);
        ((f(middle) < 0.0) == (f(a) < 0.0) ? a : b) = middle;
    }
    return a;
}

double lastRoot(const Function &f, double from, double step)
{
    return -firstRoot([&](double x) { return f(-x); }, -from, step);
}

/// Pressure and density behind a shock that runs with `mach` into a gas at rest with p = rho = 1,
/// from conservation of mass, momentum and energy; a1 = sqrt(gamma).
struct Behind
{
    double p, rho, u;
};

Behind behindShock(double gamma, double mach)
{
    const double W = mach * std::sqrt(gamma);
    const auto energyExcess = [&](double ratio) { // of densities
        const double v = W / ratio; // velocities in the frame of the shock: W before, v behind
        const double p = 1.0 + W * (W - v);
        return gamma / (gamma - 1.0) * (p / ratio - 1.0) + 0.5 * (v * v - W * W);
    };
    const double ratio = firstRoot(energyExcess, 1.01, 0.01);
    const double v = W / ratio;
    return {1.0 + W * (W - v), ratio, W - v};
}

/// Of the shock that stops that gas: its Mach number, from the velocity behind it being that.
double reflectedMachOf(double gamma, const Behind &gas)
{
    const double a = std::sqrt(gamma * gas.p / gas.rho);
    return firstRoot(
        [&](double mach) { return behindShock(gamma, mach).u * a / std::sqrt(gamma) - gas.u; },
        1.05, 0.01);
}

/// P(|T| <= k) by Simpson's rule.
double studentInside(double k, int dof)
{
    const double nu = dof;
    const double scale = std::exp(std::lgamma(0.5 * (nu + 1.0)) - std::lgamma(0.5 * nu))
        / std::sqrt(nu * std::numbers::pi);
    constexpr int kHalf = 2000;
    const double h = k / kHalf;
    double sum = 0.0;
    for (int i = 0; i <= kHalf; ++i)
        sum += (i == 0 || i == kHalf ? 1.0
                       : i % 2 == 1  ? 4.0
                                     : 2.0)
            * std::pow(1.0 + i * h * i * h / nu, -0.5 * (nu + 1.0));
    return 2.0 * scale * sum * h / 3.0;
}

/// Largest singular value and, of what is left, the next: power method on H^T H.
double ratioOfSingularValues(const Eigen::VectorXd &y, Index rows, Index columns, int iterations)
{
    Eigen::MatrixXd H(rows, columns);
    for (Index i = 0; i < rows; ++i)
        H.row(i) = y.segment(i, columns).transpose();
    Eigen::Vector2d sizes;
    for (double &size : sizes) {
        Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(columns, 1.0, 2.0);
        for (int i = 0; i < iterations; ++i)
            x = (H.transpose() * (H * x)).normalized();
        size = (H * x).norm();
        H -= (H * x) * x.transpose();
    }
    return sizes[1] / sizes[0];
}

} // namespace

class TestSelftestOracles : public QObject
{
    Q_OBJECT

private slots:
    void fractionsAtMach2_areTheConservationLaws()
    {
        const Behind two = behindShock(1.4, 2.0);
        const double reflected = reflectedMachOf(1.4, two);
        const Behind five = behindShock(1.4, reflected);
        QVERIFY(agrees("density ratio of the incident shock", two.rho));
        QVERIFY(agrees("Mach number of the reflected shock", reflected));
        QVERIFY(agrees("pressure ratio p5/p1", two.p * five.p));
        QVERIFY(agrees("temperature ratio T5/T1", two.p * five.p / (two.rho * five.rho)));
        QVERIFY(agrees("step over p1, velocity typed", two.p * five.p - 1.0));
    }

    /// Simple wave: u3 = 2 a4/(gamma - 1) (1 - (p3/p4)^((gamma - 1)/2 gamma)), p3 = p2.
    void driverPressure_isASimpleWave()
    {
        const Behind two = behindShock(1.4, 2.0);
        const double a4 = std::sqrt(1.4);
        const double p4 = firstRoot(
            [&](double p) {
                return 2.0 * a4 / 0.4 * (1.0 - std::pow(two.p / p, 0.4 / 2.8)) - two.u;
            },
            two.p, 0.5);
        QVERIFY(agrees("driver pressure p4/p1", p4));
    }

    void thesisShot_isTheSame()
    {
        const double a1 = std::sqrt(1.402 * 8.314462618 * 294.15 / 0.028966);
        const Behind two = behindShock(1.402, 512.82 / a1);
        const Behind five = behindShock(1.402, reflectedMachOf(1.402, two));
        QVERIFY(agrees("p5 of the thesis's shot, Pa", 101100.0 * two.p * five.p));
        QVERIFY(
            agrees("T5 of the thesis's shot, K", 294.15 * two.p * five.p / (two.rho * five.rho)));
    }

    void characteristics_areRoots()
    {
        const SecondOrderTruth flat{1.0, 0.7}, peaked{1.0, 0.2};
        const auto level = [&](const SecondOrderTruth &sensor, double at) {
            return Function([&sensor, at](double t) { return sensor.step(t) - at; });
        };
        const double rise
            = firstRoot(level(flat, 0.9), 0.0, 1e-3) - firstRoot(level(flat, 0.1), 0.0, 1e-3);
        QVERIFY(agrees("rise time of the model, times f0", rise));
        const double overshoot = std::exp(-0.7 * std::numbers::pi / std::sqrt(0.51));
        QVERIFY(agrees("overshoot of the model, %", 100.0 * overshoot));
        const auto outside = [&](double t) { return std::abs(peaked.step(t) - 1.0) - 0.05; };
        QVERIFY(agrees("settling time of the model, times f0", lastRoot(outside, 6.0, 1e-3)));
        const auto gain = [&](double at) {
            return Function([&peaked, at](double f) { return std::abs(peaked.response(f)) - at; });
        };
        QVERIFY(agrees("band within 5 %, over f0", firstRoot(gain(1.05), 0.01, 1e-3)));
        QVERIFY(agrees("band within 10 %, over f0", firstRoot(gain(1.1), 0.01, 1e-3)));
        QVERIFY(agrees("band to -3 dB, over f0", firstRoot(gain(std::sqrt(0.5)), 1.0, 1e-3)));
    }

    void studentsFactor_byQuadrature()
    {
        const double k = firstRoot([](double x) { return studentInside(x, 10) - 0.95; }, 1.0, 0.1);
        QVERIFY(agrees("coverage factor k for 95 %", k));
        QVERIFY(agrees("U of u = 2 with 10 degrees of freedom", 2.0 * k));
    }

    void spectrum_byTheSumItself()
    {
        const double y[]{0.0, 1.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.05};
        std::complex<long double> F = 0.0L;
        long double reRe = 0.0L, reIm = 0.0L, imIm = 0.0L;
        for (int n = 0; n < 8; ++n) {
            const auto turn = std::polar(1.0L, -2.0L * std::numbers::pi_v<long double> * n / 8.0L);
            const long double variance = 1e-4L * (n + 1) * (n + 1);
            F += static_cast<long double>(y[n]) * turn;
            reRe += variance * turn.real() * turn.real();
            reIm += variance * turn.real() * turn.imag();
            imIm += variance * turn.imag() * turn.imag();
        }
        QVERIFY(agrees("real part of a spectral line", static_cast<double>(F.real())));
        QVERIFY(agrees("covariance of its real and imaginary part", static_cast<double>(reIm)));
        const auto r = F / std::abs(F);
        QVERIFY(agrees("variance of its magnitude",
            static_cast<double>(r.real() * r.real() * reRe + 2.0L * r.real() * r.imag() * reIm
                + r.imag() * r.imag() * imIm)));
    }

    void singularValues_byThePowerMethod()
    {
        const Eigen::VectorXd y = SecondOrderTruth{318e3, 0.02}.sampled(1e6, 400, 1.0);
        const Eigen::VectorXd d = y.tail(399) - y.head(399);
        QVERIFY(agrees("second singular value over the first, differences",
            ratioOfSingularValues(d, 198, 202, 3000)));
        // The second and the third lie within 5e-4 of each other.
        QVERIFY(agrees("second singular value over the first, step as impulse",
            ratioOfSingularValues(y, 199, 199, 30000)));
    }
};

DYNCAL_TEST(TestSelftestOracles)
#include "tst_selftest_oracles.moc"
