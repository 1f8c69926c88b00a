// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/pole_mapping.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;

constexpr double kInterval_s = 1e-6;

Complex thereAndBack(Complex z)
{
    return discretePoles({continuousPole(z, kInterval_s)}, kInterval_s).front();
}

} // namespace

class TestPoleMapping : public QObject
{
    Q_OBJECT

private slots:
    /// e^(s dt) of its own s is z again, inside, on and outside the unit circle.
    void everyPole_comesBack()
    {
        for (const double radius : {1e-6, 0.3, 0.999999, 1.0, 1.7})
            for (int step = -19; step <= 20; ++step) {
                const Complex z = std::polar(radius, 0.05 * step * std::numbers::pi);
                QVERIFY(std::abs(thereAndBack(z) - z) < 1e-13 * radius);
            }
    }

    /// A sample later the response has gone on by z: the same as e^(s dt) of the sensor.
    void pole_isTheSensors()
    {
        const double w0_rad_s = 2.0 * std::numbers::pi * 30e3;
        const Complex s(-0.05 * w0_rad_s, std::sqrt(1.0 - 0.0025) * w0_rad_s);
        const Complex found = continuousPole(std::exp(s * kInterval_s), kInterval_s);
        QVERIFY(std::abs(found - s) < 1e-9 * std::abs(s));
    }

    /// Real poles stay real, those left of 0 too, whose partner would be themselves.
    void realPoles_stayReal()
    {
        for (const double z : {0.9, 1e-9, -1e-9, -0.4, -1.0, -1.2}) {
            const Complex back = thereAndBack(z);
            QCOMPARE(back.imag(), 0.0);
            QVERIFY(std::abs(back.real() - z) < 1e-13 * std::abs(z));
        }
        // Either end of the Nyquist line is the same pole.
        const Complex s = continuousPole({-0.4, 0.0}, kInterval_s);
        QCOMPARE(discretePoles({std::conj(s)}, kInterval_s).front().imag(), 0.0);
        QVERIFY(std::abs(std::abs(s.imag()) * kInterval_s - std::numbers::pi) < 1e-15);
    }

    /// Near the line, but not on it, a pole keeps its imaginary part.
    void nearTheNyquistLine_pairsStayPairs()
    {
        const Complex z = std::polar(0.5, std::numbers::pi - 1e-9);
        QVERIFY(std::abs(thereAndBack(z) - z) < 1e-15);
        QVERIFY(thereAndBack(z).imag() > 0.0);
    }

    /// A pure delay: infinitely fast, but a number that can be listed, and nothing of it is left a
    /// sample later.
    void delay_isFinite()
    {
        const Complex s = continuousPole(0.0, kInterval_s);
        QVERIFY(std::isfinite(s.real()) && s.real() < -1e8);
        QCOMPARE(s.imag(), 0.0);
        QVERIFY(std::abs(discretePoles({s}, kInterval_s).front()) < 1e-299);
        QVERIFY(std::isfinite(continuousPole({0.0, 1e-320}, kInterval_s).real()));
    }

    /// One for each, in their order; of none none.
    void list_keepsItsOrder()
    {
        QVERIFY(discretePoles({}, kInterval_s).empty());
        const std::vector<Complex> z
            = discretePoles({{-1e5, 2e5}, {-1e5, -2e5}, {-3e4, 0.0}}, kInterval_s);
        QCOMPARE(z.size(), std::size_t(3));
        QCOMPARE(z[1], std::conj(z[0]));
        QVERIFY(std::abs(z[2] - std::exp(-0.03)) < 1e-15);
    }

    /// The unit of time: s scales with 1/dt.
    void interval_scalesThePole()
    {
        const Complex z(0.3, 0.6);
        QVERIFY(std::abs(continuousPole(z, 1e-6) - 1e6 * continuousPole(z, 1.0)) < 1e-6);
    }
};

DYNCAL_TEST(TestPoleMapping)
#include "tst_pole_mapping.moc"
