// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/model_analysis/step_covariance.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kOnset_s = 2.4e-6;
constexpr Index kSamples = 1000;
const Eigen::VectorXd kFrequencies_Hz{{700.0, 1e3, 3e3, 4e4, 2.5e5, 4.1e5}};

/// Grows from sample to sample and jumps in the middle of the last tenth.
Eigen::VectorXd variances()
{
    Eigen::VectorXd variance = Eigen::VectorXd::LinSpaced(kSamples, 1e-4, 4e-4);
    variance.tail(kSamples / 20).array() *= 5.0;
    return variance;
}

std::vector<UncertainComplex> linesOf(const Eigen::VectorXd &y, const Eigen::VectorXd &variance)
{
    return stepTransformsWithCovariance(
        y, variance, kRate_Hz, transformEnds(y, 0).back(), kOnset_s, kFrequencies_Hz);
}

} // namespace

class TestStepCovariance : public QObject
{
    Q_OBJECT

private slots:
    void values_areThoseOfTheTransform()
    {
        testing::Noise noise(7);
        for (const Index size : {Index(1), Index(9), Index(10), Index(5000)}) {
            const Eigen::VectorXd y = noise.series(size, 1.0);
            const auto lines = linesOf(y, Eigen::VectorXd::Zero(size));
            for (std::size_t k = 0; k < lines.size(); ++k) {
                const double f_Hz = kFrequencies_Hz[Index(k)];
                const Complex expected
                    = stepTransforms(y, kRate_Hz, transformEnds(y, 0), kOnset_s, f_Hz).back();
                QVERIFY(std::abs(lines[k].value - expected) < 1e-11 * double(size));
                QCOMPARE(lines[k].covariance.cwiseAbs().sum(), 0.0);
            }
        }
    }

    /// The transform is linear: its derivative by sample n is the transform of a record that is 1
    /// there and 0 elsewhere, level included. V is the sum of their squares times the variances.
    void covariance_isThatOfTheTransformOfEverySample()
    {
        const Eigen::VectorXd variance = variances();
        const auto lines = linesOf(Eigen::VectorXd::Zero(kSamples), variance);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            Eigen::Matrix2d expected = Eigen::Matrix2d::Zero();
            for (Index n = 0; n < kSamples; ++n) {
                const Eigen::VectorXd one = Eigen::VectorXd::Unit(kSamples, n);
                const Complex slope = stepTransforms(
                    one, kRate_Hz, transformEnds(one, 0), kOnset_s, kFrequencies_Hz[Index(k)])
                                          .back();
                const Eigen::Vector2d J(slope.real(), slope.imag());
                expected += variance[n] * J * J.transpose();
            }
            const double size = expected.trace();
            QVERIFY2((lines[k].covariance - expected).cwiseAbs().maxCoeff() < 1e-11 * size,
                qPrintable(QString::number(kFrequencies_Hz[Index(k)])));
        }
    }

    /// What is stated for noise of one density counts the level in full for both directions: no
    /// less than the mean of both, and at the lowest frequencies of a record, where the level
    /// counts most, at least 0.87 of the larger one.
    void variance_thatIsStated_isNoLessThanTheMeanOfBoth()
    {
        const Eigen::VectorXd y = Eigen::VectorXd::Zero(kSamples);
        const TransformEnd end = transformEnds(y, 0).back();
        const auto lines = linesOf(y, Eigen::VectorXd::Constant(kSamples, 1e-4));
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const double f_Hz = kFrequencies_Hz[Index(k)];
            const Eigen::Matrix2d &V = lines[k].covariance;
            const double mean = 0.5 * V.trace();
            const double larger = mean + std::hypot(0.5 * (V(0, 0) - V(1, 1)), V(0, 1));
            const double stated = stepTransformVariance(end, kRate_Hz, 1e-4, 1e-4, f_Hz);
            QVERIFY2(stated > mean * (1.0 - 1e-9) && stated > 0.87 * larger,
                qPrintable(
                    QString("%1: %2, %3").arg(f_Hz).arg(mean / stated).arg(larger / stated)));
        }
    }
};

DYNCAL_TEST(TestStepCovariance)
#include "tst_step_covariance.moc"
