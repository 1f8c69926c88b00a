// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/fft.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QTest>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <complex>
#include <fstream>
#include <new>
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

/// False where memory lacks; a wrong result ends this process.
bool isRight(const Eigen::VectorXd &record)
try {
    const RealFft fft(record.size());
    if (!fft.inverse(fft.forward(record)).isApprox(record, 1e-12))
        ::_exit(2);
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

/// Lets this process have so much memory more than it has, and nothing of what was freed before.
/// The limit as it was.
rlimit limitMemory(std::size_t headroom_bytes)
{
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const auto bytes = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    rlimit before{};
    ::getrlimit(RLIMIT_AS, &before);
    rlimit limit{bytes, before.rlim_max};
    ::setrlimit(RLIMIT_AS, &limit);
    for (std::size_t block = 1 << 20; block >= 1024; block /= 2) {
        while (::memalign(16, block) != nullptr)
            continue;
    }
    limit.rlim_cur = bytes + headroom_bytes;
    ::setrlimit(RLIMIT_AS, &limit);
    return before;
}

/// Whether a child that may take so much memory more than it has ends by itself: with 0, or with 1
/// where memory lacked and it was told so.
bool endsByItself(Index length, std::size_t headroom_bytes, int &exitCode)
{
    const pid_t child = ::fork();
    if (child == 0) {
        const Eigen::VectorXd record = Eigen::VectorXd::LinSpaced(length, 0.0, 1.0);
        const rlimit before = limitMemory(headroom_bytes);
        const bool isDone = isRight(record);
        ::setrlimit(RLIMIT_AS, &before);
        for (int again = 0; !isDone && again < 2; ++again)
            isRight(record); // where memory is back it works, or says again that it lacks
        ::_exit(isDone ? 0 : 1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return exitCode == 0 || exitCode == 1;
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
    void transform_littleMemory_throws_data();
    void transform_littleMemory_throws();
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

void TestFft::transform_littleMemory_throws_data()
{
    QTest::addColumn<int>("length");
    const int prime = trials::count(19997, 99991); // the larger takes a second a limit
    for (const int n : {20000, 108000, prime, 2 * 49999})
        QTest::addRow("%d", n) << n;
}

void TestFft::transform_littleMemory_throws()
{
#ifdef __SANITIZE_ADDRESS__
    QSKIP("the sanitizer's own memory leaves no room for a limit");
#endif
    QFETCH(int, length);
    int done = 0, refused = 0;
    for (int step = 0; done == 0; ++step) {
        int exitCode = -1;
        const std::size_t headroom_bytes = std::size_t(step) * std::max(65536, 8 * length);
        QVERIFY2(endsByItself(length, headroom_bytes, exitCode), qPrintable(QString::number(step)));
        (exitCode == 0 ? done : refused) += 1;
    }
    QVERIFY(refused > 0);
    qInfo("%d limits refused", refused);
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
