// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Oracle: PyDynamic 2.5.1 (GUM_DFT, DFT2AmpPhase, AmpPhase2DFT, DFT_deconv), run with numpy 1.24;
// its numbers have ten digits.

#include "core/signal/dft_covariance.h"
#include "core/signal/spectral_sums.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using Complex = std::complex<double>;
using testing::Noise;

namespace {

constexpr double kAllowed = 1e-9;
constexpr Index kBins = 5;

bool isNear(double found, double expected)
{
    return std::abs(found - expected) < kAllowed;
}

/// The record of the oracle: x, and u = 0.01 to 0.08.
struct Oracle
{
    Eigen::VectorXd x{{0.0, 1.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.05}};
    Eigen::VectorXd variance = (0.01 * Eigen::ArrayXd::LinSpaced(8, 1.0, 8.0)).square();
    Eigen::VectorXd bins = Eigen::VectorXd::LinSpaced(kBins, 0.0, 4.0);

    std::vector<UncertainComplex> lines() const
    {
        return dftWithCovariance(x, variance, 8.0, bins);
    }
};

/// The sum in long double.
std::complex<long double> writtenOut(const Eigen::VectorXd &y, double turns)
{
    std::complex<long double> sum = 0.0L;
    for (Index n = 0; n < y.size(); ++n) {
        const long double at = std::fmod(static_cast<long double>(turns) * n, 1.0L);
        sum += static_cast<long double>(y[n])
            * std::polar(1.0L, -2.0L * std::numbers::pi_v<long double> * at);
    }
    return sum;
}

} // namespace

class TestDftCovariance : public QObject
{
    Q_OBJECT

private slots:
    void sums_areThoseWrittenOut_inLongDouble()
    {
        Noise noise(4);
        for (const Index size : {1, 2, 255, 256, 511, 512, 513, 2048, 16384, 16385, 50000}) {
            const Eigen::VectorXd y = noise.series(size, 1.0).array() + 0.3;
            const Eigen::VectorXd turns{{0.0, 1e-7, 0.013, 0.25, -0.1, 0.4999, 1.2}};
            const Eigen::VectorXcd found = spectralSums(y, turns);
            for (Index k = 0; k < turns.size(); ++k) {
                const auto expected = writtenOut(y, turns[k]);
                const auto error = std::abs(std::complex<long double>(found[k]) - expected);
                QVERIFY2(error < 1e-15L * static_cast<long double>(y.cwiseAbs().sum()),
                    qPrintable(QString("%1 at %2: %3").arg(size).arg(k).arg(double(error))));
                if (size > 2048)
                    QVERIFY(error < 1e-12L * std::abs(expected));
            }
        }
    }

    void sums_ofNothing_areNothing()
    {
        QCOMPARE(spectralSums(Eigen::VectorXd(), Eigen::VectorXd::Ones(3)).cwiseAbs().sum(), 0.0);
        QCOMPARE(spectralSums(Eigen::VectorXd::Ones(3), Eigen::VectorXd()).size(), Index(0));
    }

    /// A line of a whole number of turns: all of the record at its own frequency, for far samples
    /// as for near ones.
    void sums_ofALongTone_areItsAmplitude()
    {
        constexpr Index kSamples = 1 << 20;
        constexpr double kTurns = 262145.0 / kSamples;
        Eigen::VectorXd y(kSamples);
        for (Index n = 0; n < kSamples; ++n)
            y[n] = turned(kTurns, static_cast<double>(n)).real();
        const Eigen::VectorXcd found
            = spectralSums(y, Eigen::VectorXd{{kTurns, 2.0 * kTurns, 0.1, 0.2, 0.3}});
        QVERIFY(std::abs(found[0] / (0.5 * kSamples) - 1.0) < 1e-14);
        QVERIFY(std::abs(found[1]) < 1e-10 * kSamples);
    }

    void dft_equalsPyDynamic()
    {
        const auto lines = Oracle().lines();
        const double re[]{4.9, -0.6414213562, -1.6, -0.3585786438, 0.3};
        const double im[]{0.0, -3.102081528, -0.2, 0.697918472, 0.0};
        const double varRe[]{.0204, .0086, .0084, .0086, .0204};
        const double varIm[]{0.0, .0118, .0120, .0118, 0.0};
        for (std::size_t k = 0; k < lines.size(); ++k) {
            QVERIFY(isNear(lines[k].value.real(), re[k]) && isNear(lines[k].value.imag(), im[k]));
            QVERIFY(isNear(lines[k].covariance(0, 0), varRe[k]));
            QVERIFY(isNear(lines[k].covariance(1, 1), varIm[k]));
        }
        QVERIFY(isNear(lines[1].covariance(0, 1), 0.002));
        QVERIFY(isNear(lines[1].covariance(1, 0), 0.002));
    }

    void covarianceOfAllLines_equalsPyDynamic_andHoldsThatOfEach()
    {
        const Oracle oracle;
        const Eigen::MatrixXd all = dftCovariance(oracle.variance, 8.0, oracle.bins);
        QVERIFY(isNear(all(0, 1), -0.0012686291501));
        QVERIFY((all - all.transpose()).cwiseAbs().maxCoeff() < 1e-16);
        const auto lines = oracle.lines();
        for (Index k = 0; k < kBins; ++k) {
            const Eigen::Matrix2d own = all({k, kBins + k}, {k, kBins + k});
            const Eigen::Matrix2d expected = lines[static_cast<std::size_t>(k)].covariance;
            QVERIFY((own - expected).cwiseAbs().maxCoeff() < 1e-15);
        }
    }

    /// J diag(variance) J^T, with J of cosines and sines written down.
    void covarianceOfAllLines_isTheMatrixProduct_atAnyFrequency()
    {
        Noise noise(6);
        const Eigen::VectorXd variance = noise.series(700, 1.0).array().square();
        const Eigen::VectorXd f_Hz{{10.0, 333.3, 1234.5}};
        constexpr double kRate_Hz = 1e4;
        Eigen::MatrixXd J(6, 700);
        for (Index k = 0; k < 3; ++k)
            for (Index n = 0; n < 700; ++n) {
                J(k, n) = std::cos(2.0 * M_PI * f_Hz[k] / kRate_Hz * double(n));
                J(3 + k, n) = -std::sin(2.0 * M_PI * f_Hz[k] / kRate_Hz * double(n));
            }
        const Eigen::MatrixXd expected = J * variance.asDiagonal() * J.transpose();
        const Eigen::MatrixXd found = dftCovariance(variance, kRate_Hz, f_Hz);
        QVERIFY((found - expected).cwiseAbs().maxCoeff() < 1e-12 * variance.sum());
    }

    void magnitudeAndPhase_equalPyDynamic()
    {
        const auto lines = Oracle().lines();
        const double A[]{4.9, 3.1677012427, 1.6124515497, 0.7846456763, 0.3};
        const double phase[]{0.0, -1.7746941703, -3.017237659, 2.045409436, 0.0};
        const double varA[]{.0204, .012461969086, .0084553846154, .012757630045, .0204};
        const double varPhase[]{0.0, 7.9108719712e-4, .0045940828402, .012413118046, 0.0};
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const UncertainPolar polar = toPolar(lines[k]);
            QVERIFY(isNear(polar.magnitude, A[k]) && isNear(polar.phase_rad, phase[k]));
            QVERIFY(isNear(polar.covariance(0, 0), varA[k]));
            QVERIFY(isNear(polar.covariance(1, 1), varPhase[k]));
        }
    }

    void deconvolution_equalsPyDynamic()
    {
        const auto lines = Oracle().lines();
        const double amplitude[]{1.0, 1.1, 1.3, 0.9, 0.5};
        const double phase[]{0.0, -0.1, -0.3, -1.0, -2.0};
        const double re[]{4.9, -.2986595668, -1.1303341087, -.8677989022, -.2496881019};
        const double im[]{0.0, -2.8641993881, -.5106920219, .0837260391, .5455784561};
        const double u_re[]{.151, .1004701157, .0730504669, .1255211779, .1194794554};
        const double u_im[]{.098, .1037677819, .0862615386, .0991337013, .2600243445};
        for (std::size_t k = 0; k < lines.size(); ++k) {
            UncertainPolar H{amplitude[k], phase[k]};
            H.covariance.diagonal() << 1e-4, 4e-4;
            const UncertainComplex X = quotient(lines[k], toRectangular(H));
            QVERIFY(isNear(X.value.real(), re[k]) && isNear(X.value.imag(), im[k]));
            QVERIFY(isNear(std::sqrt(X.covariance(0, 0)), u_re[k]));
            QVERIFY(isNear(std::sqrt(X.covariance(1, 1)), u_im[k]));
        }
    }

    /// Twice the errors, four times the variance; none, none; the values do not change.
    void covariance_growsWithTheSquareOfTheErrors()
    {
        const Oracle oracle;
        const auto once = oracle.lines();
        const auto twice = dftWithCovariance(oracle.x, 4.0 * oracle.variance, 8.0, oracle.bins);
        const auto none = dftWithCovariance(oracle.x, Eigen::VectorXd::Zero(8), 8.0, oracle.bins);
        for (std::size_t k = 0; k < once.size(); ++k) {
            QVERIFY((twice[k].covariance - 4.0 * once[k].covariance).cwiseAbs().maxCoeff() < 1e-15);
            QCOMPARE(none[k].covariance.cwiseAbs().sum(), 0.0);
            QCOMPARE(twice[k].value, once[k].value);
        }
    }
};

DYNCAL_TEST(TestDftCovariance)
#include "tst_dft_covariance.moc"
