// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/step_transform.h"
#include "tests/support/model_inputs.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <complex>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr ResponseTreatment kStep = ResponseTreatment::StepDeflated;

Complex whole(const Eigen::VectorXd &y, double rate_Hz, double onset_s, double f_Hz)
{
    return stepTransforms(y, rate_Hz, transformEnds(y, 0), onset_s, f_Hz).back();
}

Complex transformOf(const Eigen::VectorXd &y, double level, double x)
{
    Complex D = 0.0;
    for (Index n = 0; n <= y.size(); ++n) {
        const double now = n < y.size() ? y[n] : level;
        D += (now - (n > 0 ? y[n - 1] : 0.0)) * std::polar(1.0, -x * double(n));
    }
    return D * Complex(0.0, x) / (1.0 - std::polar(1.0, -x));
}

/// Plain discrete Fourier transform at bin k of `bins`.
Complex dft(const Eigen::VectorXd &y, double k, double bins)
{
    Complex sum = 0.0;
    for (Index n = 0; n < y.size(); ++n)
        sum += y[n] * std::polar(1.0, -kTwoPi * std::fmod(k * double(n), bins) / bins);
    return sum;
}

/// Three classic ways to the spectrum of a step's derivative, for a record that has not settled.
struct ClassicWays
{
    Eigen::VectorXd y;
    double size = double(y.size());

    /// sum of (y_n - y_(n-1)) e^(-jxn) over the recorded samples, by core.
    Complex ofCore(double x) const
    {
        const TransformEnd end{y.size(), 1, y[y.size() - 1]};
        return stepTransforms(y, kRate_Hz, {end}, 0.0, x * kRate_Hz / kTwoPi)[0]
            * (1.0 - std::polar(1.0, -x)) / Complex(0.0, x);
    }
    /// A ramp to the last sample is subtracted; at bin k of N, k >= 1.
    Complex nicolson(double k) const
    {
        const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(y.size(), 1.0, size) / size;
        return (1.0 - std::polar(1.0, -kTwoPi * k / size))
            * dft(y - ramp * y[y.size() - 1], k, size);
    }
    /// The record once more, falling from its last sample; at odd bins of 2 N, of both halves.
    Complex gansNahman(double odd) const
    {
        Eigen::VectorXd both(2 * y.size());
        both << y, y[y.size() - 1] - y.array();
        return 0.5 * (1.0 - std::polar(1.0, -kTwoPi * odd / (2.0 * size)))
            * dft(both, odd, 2.0 * size);
    }
};

} // namespace

class TestStepTransform : public QObject
{
    Q_OBJECT

private slots:
    void ends_lieInTheLastThird_atTheMeanOfTheirOwnLastTenth()
    {
        const Eigen::VectorXd y = Eigen::VectorXd::LinSpaced(3000, 0.0, 2999.0);
        const std::vector<TransformEnd> ends = transformEnds(y, 12);
        QCOMPARE(ends.size(), std::size_t(13));
        QCOMPARE(ends.front().samples, Index(2000));
        QCOMPARE(ends.back().samples, Index(3000));
        for (std::size_t k = 0; k < ends.size(); ++k) {
            QCOMPARE(ends[k].averaged, ends[k].samples / 10);
            const double first = double(ends[k].samples - ends[k].averaged);
            QVERIFY(std::abs(ends[k].level - 0.5 * (first + double(ends[k].samples - 1))) < 1e-9);
            if (k > 0)
                QVERIFY(std::abs(double(ends[k].samples - ends[k - 1].samples) - 83.3) < 1.0);
        }
        QCOMPARE(transformEnds(Eigen::VectorXd(), 12).back().samples, Index(0));
        QCOMPARE(transformEnds(Eigen::VectorXd::Ones(1), 12).front().level, 1.0);
    }

    void transforms_areTheSumWrittenOut_atEveryEnd()
    {
        testing::Noise noise(3);
        for (const Index size : {Index(1), Index(2), Index(256), Index(257), Index(5000)}) {
            const Eigen::VectorXd y = noise.series(size, 1.0);
            const std::vector<TransformEnd> ends = transformEnds(y, 5);
            for (const double x : {1e-3, 0.7, 3.1}) {
                const auto found = stepTransforms(y, kRate_Hz, ends, 0.0, x * kRate_Hz / kTwoPi);
                for (std::size_t k = 0; k < ends.size(); ++k) {
                    const Complex expected = transformOf(y.head(ends[k].samples), ends[k].level, x);
                    QVERIFY(std::abs(found[k] - expected) < 1e-12 * double(size + 10));
                }
            }
        }
    }

    void transform_recoversTheSensor()
    {
        // metrology 1.4: at 10 MHz, f0 = 300 kHz, zeta = 0.02, onset half a sample before the
        // first: the bracket leaves less than 1e-4 % at 100 kHz; a long record leaves no
        // truncation.
        const double rate_Hz = 10e6;
        const SensorModel model = testing::secondOrderModel(300e3, 0.02);
        const Eigen::VectorXd y = testing::sampledStep(300e3, 0.02, rate_Hz, 20000, 0.5);
        for (const double f_Hz : {1e3, 3e4, 1e5, 2.5e5}) {
            const Complex S = whole(y, rate_Hz, -0.5 / rate_Hz, f_Hz);
            const Complex G = modelResponse(model, kStep, f_Hz);
            // Aliasing grows with frequency; 1 % of (f / rate) bounds it here.
            QVERIFY2(std::abs(S / G - 1.0) < 2e-6 + 1e-4 * f_Hz / 2.5e5,
                qPrintable(QString::number(std::abs(S / G - 1.0))));
        }
    }

    void zerosBeforeTheOnset_turnNothingButThePhase()
    {
        const Eigen::VectorXd y = testing::sampledStep(300e3, 0.02, 1e7, 3000, 0.5);
        Eigen::VectorXd later = Eigen::VectorXd::Zero(3200);
        later.tail(3000) = y;
        for (const double f_Hz : {1e3, 1e5, 4e5}) {
            const auto a = stepTransforms(y, 1e7, {{3000, 1, 1.0}}, 0.0, f_Hz);
            const auto b = stepTransforms(later, 1e7, {{3200, 1, 1.0}}, 200 / 1e7, f_Hz);
            QVERIFY(std::abs(a[0] - b[0]) < 1e-11);
        }
    }

    /// At their own frequencies: Nicolson's at the bins of N, Gans and Nahman's between them, and
    /// both together, which is Shaarawi and Riad's complete transform.
    void classicWays_giveTheSame()
    {
        testing::Noise noise(2);
        for (const Index size : {Index(400), Index(401)}) {
            const ClassicWays ways{
                testing::sampledStep(318e3, 0.02, kRate_Hz, size, 0.4) + noise.series(size, 0.01)};
            for (Index bin = 1; bin < 2 * size; ++bin) {
                const double k = double(bin);
                const Complex found = bin % 2 == 0 ? ways.nicolson(0.5 * k) : ways.gansNahman(k);
                const Complex own = ways.ofCore(kTwoPi * k / (2.0 * double(size)));
                QVERIFY2(std::abs(found - own) < 1e-10,
                    qPrintable(QString("%1: %2").arg(bin).arg(std::abs(found - own))));
            }
        }
    }

    void atZeroFrequency_isTheLevelOfTheEnd()
    {
        const Eigen::VectorXd y = testing::sampledStep(300e3, 0.02, 1e7, 500, 0.5);
        QVERIFY(std::abs(stepTransforms(y, 1e7, {{500, 50, 1.25}}, 0.0, 0.0)[0] - 1.25) < 1e-12);
    }

    void aliases_arePoissonsSum_withinTheBound()
    {
        // The error of the transform is the sum of G(f + m fs) f/(f + m fs) e^(-2 pi j m fs onset).
        const double onset_s = -0.3e-6;
        const SensorModel model = testing::secondOrderModel(300e3, 0.02);
        const Eigen::VectorXd y = testing::sampledStep(300e3, 0.02, kRate_Hz, 6000, 0.3);
        const auto G = [&](double f_Hz) {
            const Complex value = modelResponse(model, kStep, std::abs(f_Hz));
            return f_Hz > 0.0 ? value : std::conj(value);
        };
        const double top = std::abs(G(0.4 * kRate_Hz));
        for (const double f_Hz : {2e3, 1.7e5, 3.9e5}) {
            Complex aliases = 0.0;
            for (int m = -400; m <= 400; ++m)
                if (m != 0)
                    aliases += G(f_Hz + m * kRate_Hz) * f_Hz / (f_Hz + m * kRate_Hz)
                        * std::polar(1.0, -kTwoPi * m * kRate_Hz * onset_s);
            const Complex found = whole(y, kRate_Hz, onset_s, f_Hz) - G(f_Hz);
            QVERIFY(std::abs(found - aliases) < 1e-6); // the terms fall as 1/m^3
            QVERIFY(std::abs(found) < top * aliasShare(kRate_Hz, f_Hz));
        }
    }

    void aliasShare_isTheSumWrittenOut()
    {
        for (const double r : {1e-9, 0.999e-3, 1.001e-3, 0.1, 0.4}) {
            double sum = 0.0;
            for (int m = -200000; m <= 200000; ++m)
                if (m != 0)
                    sum += 0.5 / std::abs(r + m) * r / std::abs(r + m);
            // The terms left out are r/200000; the small form is good to 1e-6.
            QVERIFY(std::abs(aliasShare(kRate_Hz, r * kRate_Hz) / sum - 1.0) < 1e-5);
        }
        QCOMPARE(aliasShare(kRate_Hz, 0.0), 0.0);
    }

    void variance_isTheScatter_atEveryEnd()
    {
        constexpr Index kSamples = 1000;
        constexpr int kTrials = 400;
        testing::Noise noise(8);
        for (const double f_Hz : {3e3, 4e4, 4e5}) {
            Eigen::ArrayXd squares = Eigen::ArrayXd::Zero(3);
            std::vector<TransformEnd> ends;
            for (int trial = 0; trial < kTrials; ++trial) {
                const Eigen::VectorXd y = noise.series(kSamples, 0.01);
                ends = transformEnds(y, 2);
                const auto S = stepTransforms(y, kRate_Hz, ends, 0.0, f_Hz);
                for (Index k = 0; k < 3; ++k)
                    squares[k] += std::norm(S[std::size_t(k)]) / 2.0 / kTrials;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double stated = stepTransformVariance(ends[k], kRate_Hz, 1e-4, 1e-4, f_Hz);
                const double ratio = std::sqrt(squares[Index(k)] / stated);
                // sd of a mean of 400 squares of a complex Gaussian is 5 %; the level's part is
                // counted in full for both directions.
                QVERIFY2(ratio < 1.1 && ratio > (f_Hz < 1e4 ? 0.8 : 0.9),
                    qPrintable(QString::number(ratio)));
            }
        }
    }
};

DYNCAL_TEST(TestStepTransform)
#include "tst_step_transform.moc"
