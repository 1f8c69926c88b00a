// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/exponential_gram.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;

double valueOf(const ExponentialColumn &column, Complex exponent, Index k, double dt)
{
    const double t = static_cast<double>(k) * dt;
    const double value = (column.factor * std::exp(exponent * static_cast<double>(k))).real();
    return column.order == 0 ? value : t * value;
}

} // namespace

class TestExponentialGram : public QObject
{
    Q_OBJECT

private slots:
    void powerSums_ofOne_areTheSumsOfPowers()
    {
        for (const Index n : {Index(0), Index(1), Index(2), Index(3), Index(1000), Index(4095)}) {
            const auto sums = powerSums(1.0, n);
            const auto exact = static_cast<double>(n);
            QCOMPARE(sums[0].real(), exact);
            QCOMPARE(sums[1].real(), exact * (exact - 1.0) / 2.0);
            QCOMPARE(sums[2].real(), (exact - 1.0) * exact * (2.0 * exact - 1.0) / 6.0);
        }
    }

    void powerSums_equalTheDirectSum()
    {
        constexpr double kRounding = 1e-12; // of a thousand additions
        for (const Complex q : {Complex(0.99, 0.1), Complex(-1.0, 0.0), Complex(1.0 - 1e-9, 0.0),
                 Complex(0.0, 0.0), std::polar(1.0, 1e-7), Complex(0.3, -0.8)}) {
            for (const Index n : {Index(1), Index(7), Index(64), Index(777)}) {
                std::array<Complex, 3> direct{};
                Complex power = 1.0;
                for (Index k = 0; k < n; ++k, power *= q) {
                    const auto at = static_cast<double>(k);
                    direct[0] += power;
                    direct[1] += at * power;
                    direct[2] += at * at * power;
                }
                const auto sums = powerSums(q, n);
                double scale = 1.0;
                for (std::size_t a = 0; a < 3; ++a, scale *= static_cast<double>(n))
                    QVERIFY(std::abs(sums[a] - direct[a])
                        <= kRounding * scale * static_cast<double>(n));
            }
        }
    }

    void product_equalsTheDirectSum()
    {
        constexpr double kRounding = 1e-12;
        const double dt = 0.3;
        const std::vector<Complex> exponents{{-2e-3, 0.4}, {-5e-3, 0.0}, {0.0, 0.0}, {-1e-4, 2.9}};
        std::vector<ExponentialColumn> columns;
        for (std::size_t mode = 0; mode < exponents.size(); ++mode) {
            columns.push_back({{0.7, -0.2}, mode, 0});
            columns.push_back({{0.1, 1.3}, mode, 1});
        }
        const std::vector<SampleRange> ranges{{3, 250}, {300, 301}, {400, 1000}};
        const ExponentialGram gram(exponents, ranges);
        for (const ExponentialColumn &a : columns) {
            for (const ExponentialColumn &b : columns) {
                double direct = 0.0;
                double size = 0.0;
                for (const SampleRange &range : ranges) {
                    for (Index k = range.begin; k < range.end; ++k) {
                        const double term = valueOf(a, exponents[a.mode], k, dt)
                            * valueOf(b, exponents[b.mode], k, dt);
                        direct += term;
                        size += std::abs(term);
                    }
                }
                QVERIFY(std::abs(gram.product(a, b, dt) - direct) <= kRounding * size);
                QCOMPARE(gram.product(a, b, dt), gram.product(b, a, dt));
            }
        }
    }

    void product_overNoSamples_isZero()
    {
        const ExponentialColumn column{1.0, 0, 1};
        QCOMPARE(ExponentialGram({Complex(-0.1, 0.2)}, {}).product(column, column, 1.0), 0.0);
        QCOMPARE(ExponentialGram({Complex(-0.1, 0.2)}, {{5, 5}}).product(column, column, 1.0), 0.0);
    }

    void product_farBeyondTheDecay_staysFinite()
    {
        // e^(-3e5) at the end, and a range that begins where nothing is left.
        const ExponentialColumn column{1.0, 0, 1};
        const double whole
            = ExponentialGram({Complex(-0.3, 0.1)}, {{0, 1'000'000}}).product(column, column, 1.0);
        const double head
            = ExponentialGram({Complex(-0.3, 0.1)}, {{0, 400}}).product(column, column, 1.0);
        QVERIFY(whole > 0.0 && std::abs(whole - head) <= 1e-13 * head);
        QCOMPARE(ExponentialGram({Complex(-0.3, 0.1)}, {{900'000, 1'000'000}})
                     .product(column, column, 1.0),
            0.0);
    }
};

DYNCAL_TEST(TestExponentialGram)
#include "tst_exponential_gram.moc"
