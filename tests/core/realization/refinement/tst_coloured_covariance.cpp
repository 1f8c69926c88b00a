// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/noise_basis.h"
#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/refinement.h"
#include "tests/support/simulated_calibration.h"
#include "tests/support/test_program.h"

#include <Eigen/LU>

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kSd = 0.02;
const std::complex<double> kPair(-9e3, 1.9e5);
const std::complex<double> kTube(-1e3, 4.3e4);

/// 1 + Re(-(1 + 0.1 i) e^(s t)) with a real pole beside it, and a mode of the tube.
RefinementRecord record(Index count, bool withTube)
{
    RefinementRecord result;
    result.rate_Hz = kRate_Hz;
    result.weight = 1.0 / kSd;
    result.y.resize(count);
    for (Index k = 0; k < count; ++k) {
        const double t_s = static_cast<double>(k) / kRate_Hz;
        result.y[k] = 1.0 - 0.3 * std::exp(-4e4 * t_s)
            - (std::complex<double>(0.7, 0.1) * std::exp(kPair * t_s)).real();
        if (withTube)
            result.y[k] += 0.2 * std::exp(kTube * t_s).real();
    }
    if (withTube)
        result.nuisance.push_back({0, true, kTube, {}});
    return result;
}

const std::vector<std::complex<double>> kRates{kPair, std::conj(kPair), {-4e4, 0.0}};

/// Exact covariance of an AR(1) process as if read from a very long record.
NoiseCovariance firstOrder(double a)
{
    NoiseCovariance covariance{Eigen::VectorXd(kLargestNoiseModelOrder + 1), 100000};
    for (Index lag = 0; lag < covariance.values.size(); ++lag)
        covariance.values[lag] = kSd * kSd * std::pow(a, static_cast<double>(lag));
    return covariance;
}

/// Value of one record with parameter `index` of the joint covariance moved.
Eigen::VectorXd moved(
    const Refinement &fit, const RefinementRecord &data, Index r, Index index, double delta)
{
    const std::size_t at = static_cast<std::size_t>(r);
    const Index n = fit.poleParameters;
    const Index own = fit.offsets[at];
    const Index nuisance = own + n + 1;
    const bool isMine = index < n || (index >= own && index < nuisance);
    const ExponentialSum sum
        = isMine ? perturbed(fit, r, index < n ? index : n + index - own, delta) : fit.records[at];
    std::vector<NuisanceTerm> terms = fit.nuisance[at];
    const Index inTerm = index - nuisance;
    if (inTerm >= 0 && inTerm < 4 * std::ssize(terms)) {
        NuisanceTerm &term = terms[static_cast<std::size_t>(inTerm / 4)];
        const std::complex<double> step = inTerm % 2 ? std::complex<double>(0.0, delta) : delta;
        (inTerm % 4 < 2 ? term.pole_rad_s : term.amplitude) += step;
    }
    Eigen::VectorXd y(data.y.size());
    for (Index k = 0; k < y.size(); ++k) {
        const double t_s = static_cast<double>(k) / data.rate_Hz;
        y[k] = sum.value(t_s);
        for (const NuisanceTerm &term : terms)
            y[k] += term.value(t_s);
    }
    return y;
}

/// Independent, dense: sensitivities by differences, the noise's covariance as a whole matrix.
Eigen::MatrixXd denseSandwich(
    const std::vector<RefinementRecord> &records, const Refinement &fit, double a)
{
    const Index count = fit.covariance.rows();
    const Eigen::VectorXd unit = fit.covariance.diagonal().cwiseSqrt();
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
    Eigen::MatrixXd filling = information;
    for (std::size_t r = 0; r < records.size(); ++r) {
        const RefinementRecord &data = records[r];
        const Index samples = data.y.size();
        Eigen::MatrixXd J(samples, count);
        for (Index i = 0; i < count; ++i) {
            const double step = 1e-3 * unit[i];
            J.col(i) = (moved(fit, data, static_cast<Index>(r), i, step)
                           - moved(fit, data, static_cast<Index>(r), i, -step))
                / 2e-3;
        }
        if (!data.used.empty()) {
            Eigen::VectorXd takesPart = Eigen::VectorXd::Zero(samples);
            for (const SampleRange &range : data.used)
                takesPart.segment(range.begin, range.size()).setOnes();
            J = takesPart.asDiagonal() * J;
        }
        Eigen::MatrixXd S(samples, samples);
        for (Index i = 0; i < samples; ++i) {
            for (Index k = 0; k < samples; ++k)
                S(i, k) = kSd * kSd * std::pow(a, static_cast<double>(std::abs(i - k)));
        }
        const double w2 = data.weight * data.weight;
        information += w2 * (J.transpose() * J);
        filling += w2 * w2 * (J.transpose() * S * J);
    }
    const Eigen::MatrixXd inverse = information.inverse();
    return unit.asDiagonal() * (inverse * filling * inverse) * unit.asDiagonal();
}

double largestDifference(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
{
    const Eigen::VectorXd unit = b.diagonal().cwiseSqrt().cwiseInverse();
    return (unit.asDiagonal() * (a - b) * unit.asDiagonal()).cwiseAbs().maxCoeff();
}

} // namespace

class TestColouredCovariance : public QObject
{
    Q_OBJECT

private slots:
    void covariance_isThatOfTheDenseMatrices_data()
    {
        QTest::addColumn<double>("a");
        QTest::addColumn<bool>("withTube");
        QTest::addColumn<bool>("withGaps");
        QTest::newRow("slow noise") << 0.9 << false << false;
        QTest::newRow("fast noise") << -0.7 << false << false;
        QTest::newRow("a mode of the tube") << 0.9 << true << false;
        QTest::newRow("stretches left out") << 0.9 << true << true;
    }
    void covariance_isThatOfTheDenseMatrices()
    {
        QFETCH(double, a);
        QFETCH(bool, withTube);
        QFETCH(bool, withGaps);
        // Two records of different length, one of them longer than a block.
        std::vector<RefinementRecord> records{record(200, withTube), record(300, false)};
        records[1].weight *= 0.5;
        if (withGaps) {
            records[0].used = {{0, 60}, {75, 200}};
            records[1].used = {{10, 250}, {260, 280}};
        }
        auto fit = refinePoles(records, kRates, true);
        QVERIFY(fit.has_value());
        const Eigen::MatrixXd expected = denseSandwich(records, *fit, a);
        const NoiseBasis basis = allowForColour(records, {firstOrder(a), firstOrder(a)}, *fit);
        QCOMPARE(basis.order, Index(1));
        QVERIFY(!basis.fromResidual);
        // Differences of the sensitivities: 1e-6 of them.
        QVERIFY2(largestDifference(fit->covariance, expected) < 1e-4,
            qPrintable(QString::number(largestDifference(fit->covariance, expected))));
    }

    void slopesAndLevels_areThoseOfTheDenseMatrices_data()
    {
        QTest::addColumn<double>("timeConstants");
        QTest::addColumn<double>("bound");
        QTest::newRow("unsettled") << 2.0 << 2e-4;
        QTest::newRow("nearly a ramp") << 0.2 << 2e-4;
        // Amplitudes are 50 times the slope and cancel: rounding reaches 3e-4 of a variance.
        QTest::newRow("hardly to be told from a ramp") << 0.02 << 1e-3;
    }
    void slopesAndLevels_areThoseOfTheDenseMatrices()
    {
        QFETCH(double, timeConstants);
        QFETCH(double, bound);
        // A slope of 0.1 over the record, of which the rate is the curvature.
        const double rate = -timeConstants * kRate_Hz / 300.0;
        std::vector<RefinementRecord> records{record(200, false), record(300, true)};
        for (RefinementRecord &one : records)
            for (Index k = 0; k < one.y.size(); ++k)
                one.y[k] += 0.1 / timeConstants
                    * std::expm1(rate * static_cast<double>(k) / one.rate_Hz);
        std::vector<std::complex<double>> rates = kRates;
        rates.insert(rates.begin(), rate);
        auto fit = refinePoles(records, rates, true);
        QVERIFY(fit.has_value());
        QCOMPARE(fit->relaxing, std::vector<Index>{0});
        const Eigen::MatrixXd expected = denseSandwich(records, *fit, 0.9);
        allowForColour(records, {firstOrder(0.9), firstOrder(0.9)}, *fit);
        QVERIFY2(largestDifference(fit->covariance, expected) < bound,
            qPrintable(QString::number(largestDifference(fit->covariance, expected))));
    }

    void whiteNoise_leavesTheRefinementAlone()
    {
        RefinementRecord data = record(400, false);
        testing::Noise noise(3);
        data.y += noise.series(400, kSd);
        auto fit = refinePoles({data}, kRates, true);
        QVERIFY(fit.has_value());
        const Eigen::MatrixXd before = fit->covariance;
        const NoiseBasis basis = allowForColour(
            {data}, {noiseCovariance(noise.series(2000, kSd), kLargestNoiseModelOrder)}, *fit);
        QCOMPARE(basis.order, Index(0));
        QVERIFY(!basis.fromResidual);
        QVERIFY(fit->covariance == before);
        QCOMPARE(basis.dof, 400.0 - 3.0 - 4.0);
    }

    void scatterOfTwoHundredFits_isTheStatedOne()
    {
        constexpr int kTrials = 200;
        constexpr double kScatter = 0.4; // sd of a variance from 200 draws is 10 %: four of them
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        Eigen::Vector3d stated = Eigen::Vector3d::Zero();
        for (int trial = 0; trial < kTrials; ++trial) {
            RandomStream random(static_cast<std::uint64_t>(trial), 1, 5);
            const Eigen::VectorXd noise = testing::simulatedNoise(random, 1400, kSd, 0.9);
            RefinementRecord data = record(400, false);
            data.y += noise.tail(400);
            auto fit = refinePoles({data}, kRates, true);
            if (!fit)
                continue;
            allowForColour(
                {data}, {noiseCovariance(noise.head(1000), kLargestNoiseModelOrder)}, *fit);
            const std::complex<double> error = fit->poles_rad_s[0] - kPair;
            squares += Eigen::Vector3d(error.real(), error.imag(), fit->records[0].constant - 1.0)
                           .cwiseAbs2();
            stated += Eigen::Vector3d(
                fit->covariance(0, 0), fit->covariance(1, 1), fit->covariance(6, 6));
        }
        const Eigen::Array3d ratio = squares.array() / stated.array();
        qInfo(
            "variance over the stated one: %.2f, %.2f, plateau %.2f", ratio[0], ratio[1], ratio[2]);
        QVERIFY((ratio - 1.0).abs().maxCoeff() < kScatter);
    }

    void residualBeyondTheNoise_decides()
    {
        // A slow disturbance that the quiet record before the start does not show.
        RandomStream random(4, 1, 5);
        RefinementRecord data = record(600, false);
        data.y += testing::simulatedNoise(random, 600, 4.0 * kSd, 0.9);
        const NoiseCovariance quiet = noiseCovariance(
            testing::simulatedNoise(random, 1000, kSd, 0.0), kLargestNoiseModelOrder);
        auto fit = refinePoles({data}, kRates, true);
        QVERIFY(fit.has_value());
        const double white = fit->covariance(1, 1);
        const NoiseBasis basis = allowForColour({data}, {quiet}, *fit);
        QVERIFY(basis.fromResidual);
        QVERIFY(basis.order >= 1);
        // At 30 kHz this disturbance has 4.5 times the density of white noise of its size.
        const double ratio = fit->covariance(1, 1) / white;
        QVERIFY2(ratio > 2.0 && ratio < 8.0, qPrintable(QString::number(ratio)));
    }

    void withoutNoiseRecord_theResidualDecides()
    {
        RandomStream random(8, 1, 5);
        RefinementRecord data = record(600, false);
        data.y += testing::simulatedNoise(random, 600, kSd, 0.9);
        auto fit = refinePoles({data}, kRates, true);
        QVERIFY(fit.has_value());
        const NoiseBasis basis = allowForColour({data}, {NoiseCovariance()}, *fit);
        QVERIFY(basis.fromResidual);
        QVERIFY(basis.order >= 1);
        QVERIFY(fit->covariance.allFinite());
    }

    void noiseFreeRecord_staysFinite()
    {
        auto fit = refinePoles({record(300, true)}, kRates, true);
        QVERIFY(fit.has_value());
        allowForColour({record(300, true)},
            {noiseCovariance(Eigen::VectorXd::Zero(100), kLargestNoiseModelOrder)}, *fit);
        QVERIFY(fit->covariance.allFinite());
    }
};

DYNCAL_TEST(TestColouredCovariance)
#include "tst_coloured_covariance.moc"
