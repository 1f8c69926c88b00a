// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/fft.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <complex>
#include <numbers>
#include <thread>
#include <vector>

using namespace dyncal;
using dyncal::testing::Gaussian;

namespace {

/// A few roundings per butterfly level; values are of order 1 to sqrt(n).
constexpr double kRounding = 1e-13;

Eigen::VectorXcd directTransform(const Eigen::VectorXd &x)
{
    const Index n = x.size();
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero(n / 2 + 1);
    for (Index k = 0; k < spectrum.size(); ++k) {
        for (Index i = 0; i < n; ++i) {
            // k i mod n keeps the angle small: the oracle must not lose digits itself
            const auto turn = static_cast<double>(k * i % n) / static_cast<double>(n);
            spectrum[k] += x[i] * std::polar(1.0, -2.0 * std::numbers::pi * turn);
        }
    }
    return spectrum;
}

} // namespace

class TestFft : public QObject
{
    Q_OBJECT

private slots:
    void forward_anyLength_equalsDirectSum_data();
    void forward_anyLength_equalsDirectSum();
    void inverse_ofForward_isIdentity_data() { forward_anyLength_equalsDirectSum_data(); }
    void inverse_ofForward_isIdentity();
    void forward_shortInput_isZeroPadded();
    void forward_misalignedInput_equalsAligned();
    void forward_cosine_fillsOneBin();
    void forward_repeatedPlan_isBitIdentical();
    void forward_manyThreads_agreeBitwise();
    void moved_transform_stillWorks();
    void fastFftLength_anyN_equalsSearch();
};

void TestFft::forward_anyLength_equalsDirectSum_data()
{
    QTest::addColumn<int>("length");
    for (const int n : {1, 2, 3, 4, 5, 7, 8, 16, 97, 100, 243, 256, 1000})
        QTest::addRow("%d", n) << n;
}

void TestFft::forward_anyLength_equalsDirectSum()
{
    QFETCH(int, length);
    const Eigen::VectorXd x = Gaussian(1).vector(length, 1.0);
    const Eigen::VectorXcd difference = RealFft(length).forward(x) - directTransform(x);
    QVERIFY(difference.norm() <= kRounding * length * (1.0 + x.norm()));
}

void TestFft::inverse_ofForward_isIdentity()
{
    QFETCH(int, length);
    const Eigen::VectorXd x = Gaussian(2).vector(length, 1.0);
    const RealFft fft(length);
    const Eigen::VectorXcd spectrum = fft.forward(x);
    const Eigen::VectorXcd before = spectrum;
    QVERIFY((fft.inverse(spectrum) - x).norm() <= kRounding * (1.0 + x.norm()));
    QVERIFY2(spectrum == before, "the inverse must not write into its input");
}

void TestFft::forward_shortInput_isZeroPadded()
{
    Eigen::VectorXd x = Eigen::VectorXd::Zero(64);
    x.head(40) = Gaussian(3).vector(40, 1.0);
    const RealFft fft(64);
    QCOMPARE(fft.length(), Index(64));
    QVERIFY(fft.forward(x.head(40)) == fft.forward(x));
    QVERIFY(fft.forward(Eigen::VectorXd()).isZero(0.0));
}

void TestFft::forward_misalignedInput_equalsAligned()
{
    const Eigen::VectorXd x = Gaussian(4).vector(101, 1.0);
    const Eigen::VectorXd copy = x.tail(100);
    const RealFft fft(100);
    QVERIFY(fft.forward(x.tail(100)) == fft.forward(copy));
}

void TestFft::forward_cosine_fillsOneBin()
{
    constexpr Index n = 48, bin = 5;
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(n, [](Index i) {
        return std::cos(2.0 * std::numbers::pi * bin * static_cast<double>(i) / n + 0.3);
    });
    const Eigen::VectorXcd spectrum = RealFft(n).forward(x);
    for (Index k = 0; k < spectrum.size(); ++k) {
        // e^(-jwt) convention: a phase lead of 0.3 rad is +0.3 in the spectrum
        const auto expected = k == bin ? std::polar(n / 2.0, 0.3) : 0.0;
        QVERIFY(std::abs(spectrum[k] - expected) < kRounding * n);
    }
}

void TestFft::forward_repeatedPlan_isBitIdentical()
{
    const Eigen::VectorXd x = Gaussian(5).vector(1009, 1.0);
    const Eigen::VectorXcd first = RealFft(1009).forward(x);
    for (int i = 0; i < 20; ++i)
        QVERIFY(RealFft(1009).forward(x) == first);
}

void TestFft::forward_manyThreads_agreeBitwise()
{
    constexpr Index n = 3000;
    const Eigen::VectorXd x = Gaussian(6).vector(n, 1.0);
    const RealFft shared(n);
    const Eigen::VectorXcd expected = shared.forward(x);
    std::vector<int> good(8, 0);
    std::vector<std::jthread> threads;
    for (int &result : good) {
        threads.emplace_back([&] { // plans of its own and the shared one, at the same time
            for (int i = 0; i < 25; ++i)
                result += shared.forward(x) == expected && RealFft(n).forward(x) == expected;
        });
    }
    threads.clear();
    QCOMPARE(good, std::vector<int>(8, 25));
}

void TestFft::moved_transform_stillWorks()
{
    RealFft first(10);
    RealFft second = std::move(first);
    second = RealFft(12);
    QCOMPARE(second.length(), Index(12));
    QCOMPARE(second.forward(Eigen::VectorXd::Ones(12))[0], std::complex<double>(12.0));
}

void TestFft::fastFftLength_anyN_equalsSearch()
{
    const auto isFast = [](Index n) {
        for (const Index prime : {2, 3, 5}) {
            while (n % prime == 0)
                n /= prime;
        }
        return n == 1;
    };
    for (Index n = 1; n <= 5000; ++n) {
        Index expected = n;
        while (!isFast(expected))
            ++expected;
        QCOMPARE(fastFftLength(n), expected);
    }
    QCOMPARE(fastFftLength(100'000'001), Index(100'663'296)); // 2^25 * 3
}

DYNCAL_TEST(TestFft)
#include "tst_fft.moc"
