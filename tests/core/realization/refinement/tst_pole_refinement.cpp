// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/refinement.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <Eigen/LU>

#include <QTest>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
const std::complex<double> kPair(-6e3, 2e5);
const std::complex<double> kAmplitude(-0.5, 0.1);

/// c0 + sum of the given poles and amplitudes, pairs by their upper half.
ExponentialSum pairSum(std::complex<double> s, std::complex<double> c, double constant)
{
    ExponentialSum sum;
    sum.constant = constant;
    sum.poles_rad_s.resize(2);
    sum.poles_rad_s << s, std::conj(s);
    sum.amplitudes.resize(2);
    sum.amplitudes << c, std::conj(c);
    return sum;
}

ExponentialSum realSum(double s, double c)
{
    ExponentialSum sum;
    sum.poles_rad_s = Eigen::VectorXcd::Constant(1, s);
    sum.amplitudes = Eigen::VectorXcd::Constant(1, c);
    return sum;
}

RefinementRecord recordOf(const ExponentialSum &truth, Index count, double noise = 0.0,
    std::uint64_t seed = 1, double rate_Hz = kRate_Hz)
{
    RefinementRecord record;
    record.rate_Hz = rate_Hz;
    record.weight = noise > 0.0 ? 1.0 / noise : 1.0;
    record.y = testing::Noise(seed).series(count, noise);
    for (Index k = 0; k < count; ++k)
        record.y[k] += truth.value(static_cast<double>(k) / rate_Hz);
    return record;
}

std::vector<std::complex<double>> pairOf(std::complex<double> s)
{
    return {s, std::conj(s)};
}

/// Value at t, for the consistency of perturbed() with the model's parameters.
Eigen::VectorXd sampled(const ExponentialSum &sum, Index count)
{
    Eigen::VectorXd y(count);
    for (Index k = 0; k < count; ++k)
        y[k] = sum.value(static_cast<double>(k) / kRate_Hz);
    return y;
}

} // namespace

class TestPoleRefinement : public QObject
{
    Q_OBJECT

private slots:
    void polesThatTheRecordCannotTellApart_noResult()
    {
        // Singular normal equations: variances from them would be anything, zero too.
        for (const double noise : {0.0, 0.01}) {
            for (std::uint64_t seed = 1; seed <= 10; ++seed) {
                const auto record = recordOf(pairSum(kPair, kAmplitude, 1.0), 200, noise, seed);
                std::vector<std::complex<double>> twice = pairOf(kPair);
                twice.insert(twice.end(), {kPair, std::conj(kPair)});
                const auto fit = refinePoles({record}, twice, true);
                for (Index i = 0; fit && i < 4; ++i)
                    QVERIFY(fit->covariance(i, i) > 0.0);
                QVERIFY(!fit || (fit->poles_rad_s[0] != fit->poles_rad_s[2]));
            }
        }
    }

    void startsApart_agreeToAThousandthOfTheUncertainty()
    {
        const auto record = recordOf(pairSum(kPair, kAmplitude, 1.0), 800, 0.01);
        const auto near = refinePoles({record}, pairOf(kPair), true);
        QVERIFY(near.has_value());
        const double u = std::sqrt(near->covariance(0, 0) + near->covariance(1, 1));
        for (const std::complex<double> start :
            {std::complex<double>(-9e3, 2.02e5), {-4e3, 1.97e5}, {-1.2e4, 2.05e5}}) {
            const auto fit = refinePoles({record}, pairOf(start), true);
            QVERIFY(fit.has_value());
            QVERIFY(std::abs(fit->poles_rad_s[0] - near->poles_rad_s[0]) < 2e-3 * u);
        }
    }

    void longRecord_begunOnMeans_endsOnTheSamples()
    {
        // The minimum on the means lies a share of u away from that on the samples.
        const auto record = recordOf(pairSum(kPair, kAmplitude, 1.0), 6000, 0.05, 3, 2e7);
        const auto truth = refinePoles({record}, pairOf(kPair), true);
        QVERIFY(truth.has_value());
        const double u = std::sqrt(truth->covariance(0, 0) + truth->covariance(1, 1));
        QVERIFY(std::abs(truth->poles_rad_s[0] - kPair) < 4.0 * u);
        for (const std::complex<double> start :
            {std::complex<double>(-9e3, 2.02e5), {-4e3, 1.97e5}, {-1.2e4, 2.05e5}}) {
            const auto fit = refinePoles({record}, pairOf(start), true);
            QVERIFY(fit.has_value());
            QVERIFY(std::abs(fit->poles_rad_s[0] - truth->poles_rad_s[0]) < 2e-3 * u);
            QVERIFY(std::abs(fit->covariance(1, 1) / truth->covariance(1, 1) - 1.0) < 1e-3);
        }
        // Samples left out take no part in either.
        RefinementRecord spoilt = record;
        spoilt.used = {{0, 1003}, {1017, 6000}};
        const auto clean = refinePoles({spoilt}, pairOf({-9e3, 2.02e5}), true);
        spoilt.y.segment(1003, 14).setConstant(1e3);
        const auto fit = refinePoles({spoilt}, pairOf({-9e3, 2.02e5}), true);
        QVERIFY(clean.has_value() && fit.has_value());
        QVERIFY(std::abs(fit->poles_rad_s[0] - clean->poles_rad_s[0]) < 1e-6 * u);
    }

    void longRecord_withAFasterTermOfItsOwn_isNotAveragedAway()
    {
        // Means made for the sensor alone would hold less than one a period of the term.
        const std::complex<double> fast(-2e4, 2.6e6);
        RefinementRecord record = recordOf(pairSum(kPair, kAmplitude, 1.0), 12000, 0.01, 4, 2e7);
        for (Index k = 0; k < record.y.size(); ++k)
            record.y[k]
                += (0.2 * std::exp(fast * (static_cast<double>(k) / record.rate_Hz))).real();
        record.nuisance.push_back({0, true, 1.01 * fast, {}});
        const auto fit = refinePoles({record}, pairOf({-7e3, 2.01e5}), true);
        QVERIFY(fit.has_value());
        const double u = std::sqrt(nuisanceCovariance(*fit, 0, 0).diagonal().head(2).sum());
        QVERIFY(std::abs(fit->nuisance[0][0].pole_rad_s - fast) < 4.0 * u);
        QVERIFY(u < 1e-3 * std::abs(fast));
    }

    void poleAsSlowAsARecordOfAges_isTakenAsItIs()
    {
        // A factor of means beyond every integer must not be formed.
        const auto record = recordOf(pairSum(kPair, kAmplitude, 1.0), 3000, 0.01, 4);
        const auto fit = refinePoles({record}, {{-1e-300, 0.0}}, true);
        QVERIFY(!fit || fit->covariance.allFinite());
    }

    void wrongStart_convergesToTheTruth()
    {
        const auto record = recordOf(pairSum(kPair, kAmplitude, 1.0), 800);
        // Several periods drift apart over the record beyond a few percent: the realisation, from
        // which a fit starts, is far closer.
        for (const std::complex<double> start :
            {std::complex<double>(-9e3, 2.02e5), {-4e3, 1.97e5}, {-1.2e4, 2.05e5}, {-6e3, 2e5}}) {
            const auto fit = refinePoles({record}, pairOf(start), true);
            QVERIFY(fit.has_value());
            QVERIFY(std::abs(fit->poles_rad_s[0] - kPair) < 1e-7 * std::abs(kPair));
            QCOMPARE(fit->poles_rad_s[1], std::conj(fit->poles_rad_s[0]));
            QVERIFY(std::abs(fit->records[0].amplitudes[0] - kAmplitude) < 1e-6);
            QVERIFY(std::abs(fit->records[0].constant - 1.0) < 1e-7);
        }
    }

    void records_ofDifferentRate_shareTheirPoles()
    {
        const auto first = recordOf(pairSum(kPair, kAmplitude, 1.0), 800, 0.0, 1, 1e6);
        const auto second = recordOf(pairSum(kPair, {0.3, 0.7}, -2.0), 900, 0.0, 1, 1.25e6);
        const auto fit = refinePoles({first, second}, pairOf({-7e3, 2.01e5}), true);
        QVERIFY(fit.has_value());
        QVERIFY(std::abs(fit->poles_rad_s[0] - kPair) < 1e-7 * std::abs(kPair));
        QVERIFY(std::abs(fit->records[1].amplitudes[0] - std::complex<double>(0.3, 0.7)) < 1e-6);
        QVERIFY(std::abs(fit->records[1].constant + 2.0) < 1e-6);
    }

    void covarianceOfOneExponential_equalsTheClosedForm()
    {
        // y = c e^(s t): J columns c t e^(st), e^(st). Sums by q = e^(2 s dt) over all k:
        // S0 = 1/(1-q), S1 = q/(1-q)^2, S2 = q(1+q)/(1-q)^3; the record is long enough for them.
        constexpr double kNoise = 1e-3;
        const double s = -2e4;
        const double c = 0.8;
        const double dt = 1.0 / kRate_Hz;
        const double q = std::exp(2.0 * s * dt);
        const double S0 = 1.0 / (1.0 - q);
        const double S1 = q / std::pow(1.0 - q, 2) * dt;
        const double S2 = q * (1.0 + q) / std::pow(1.0 - q, 3) * dt * dt;
        Eigen::Matrix2d fisher;
        fisher << c * c * S2, c * S1, c * S1, S0;
        const Eigen::Matrix2d truth = fisher.inverse() * kNoise * kNoise;

        auto record = recordOf(realSum(s, c), 2000);
        record.weight = 1.0 / kNoise; // noise-free: chi square 0, so the noise stated counts
        const auto fit = refinePoles({record}, {std::complex<double>(-2.5e4)}, false);
        QVERIFY(fit.has_value());
        QCOMPARE(fit->poleParameters, Index(1));
        QCOMPARE(fit->covariance.rows(), Index(2));
        const Eigen::Matrix2d relative = fit->covariance.array() / truth.array() - 1.0;
        QVERIFY2(relative.cwiseAbs().maxCoeff() < 1e-5,
            qPrintable(QString::number(relative.cwiseAbs().maxCoeff())));
    }

    void covariance_matchesTheScatterOfTwoHundredFits()
    {
        constexpr int kTrials = 200;
        constexpr double kNoise = 0.01;
        // sd of a variance from 200 draws is 10 %: four of them.
        constexpr double kScatter = 0.4;
        const ExponentialSum truth = pairSum(kPair, kAmplitude, 1.0);
        Eigen::VectorXd squares = Eigen::VectorXd::Zero(5);
        Eigen::VectorXd stated = Eigen::VectorXd::Zero(5);
        for (int trial = 0; trial < kTrials; ++trial) {
            const auto fit = refinePoles(
                {recordOf(truth, 400, kNoise, static_cast<std::uint64_t>(trial + 10))},
                pairOf(kPair), true);
            QVERIFY(fit.has_value());
            const std::complex<double> ds = fit->poles_rad_s[0] - kPair;
            // Amplitudes are parametrised as 2 Re, 2 Im.
            const std::complex<double> dc = 2.0 * (fit->records[0].amplitudes[0] - kAmplitude);
            Eigen::VectorXd error(5);
            error << ds.real(), ds.imag(), dc.real(), dc.imag(), fit->records[0].constant - 1.0;
            squares += error.cwiseAbs2() / kTrials;
            stated += fit->covariance.diagonal() / kTrials;
        }
        const Eigen::ArrayXd ratio = squares.array() / stated.array();
        QVERIFY2((ratio - 1.0).abs().maxCoeff() < kScatter,
            qPrintable(QString::number((ratio - 1.0).abs().maxCoeff())));
    }

    void residual_largerThanTheNoise_widensTheCovariance()
    {
        const ExponentialSum truth = pairSum(kPair, kAmplitude, 1.0);
        auto record = recordOf(truth, 800, 0.01, 3);
        const auto honest = refinePoles({record}, pairOf(kPair), true);
        record.weight *= 5.0; // noise stated five times too small
        const auto tooSure = refinePoles({record}, pairOf(kPair), true);
        QVERIFY(honest && tooSure);
        QVERIFY(std::abs(honest->residualToNoise - 1.0) < 0.15);
        QVERIFY(std::abs(tooSure->residualToNoise / honest->residualToNoise - 5.0) < 1e-6);
        const double widened = std::sqrt(tooSure->covariance(0, 0) / honest->covariance(0, 0));
        QVERIFY(widened > 0.85 && widened < 1.15);
    }

    /// Level 1 and a slope of `change` over 3 ms, of a part with so many time constants in them.
    static ExponentialSum slowSum(double timeConstants, double change)
    {
        ExponentialSum sum = pairSum(kPair, kAmplitude, 0.0);
        sum.poles_rad_s.conservativeResize(3);
        sum.amplitudes.conservativeResize(3);
        sum.poles_rad_s[2] = -timeConstants / 3e-3;
        sum.amplitudes[2] = change / timeConstants;
        sum.constant = 1.0 - change / timeConstants;
        return sum;
    }
    static std::vector<std::complex<double>> startOf(double timeConstants)
    {
        return {{-timeConstants / 3e-3, 0.0}, kPair, std::conj(kPair)};
    }
    static double levelOf(const Refinement &fit)
    {
        return fit.records[0].constant + fit.records[0].amplitudes[0].real();
    }

    void slowPart_isFoundFromEveryStart_data()
    {
        QTest::addColumn<double>("timeConstants");
        QTest::addColumn<double>("change");
        QTest::newRow("AC coupling, hardly begun") << 0.02 << 0.02;
        QTest::newRow("AC coupling") << 0.09 << 0.09;
        QTest::newRow("heat") << 0.9 << 0.018;
        QTest::newRow("a ramp in all but name") << 1e-4 << 0.05;
        QTest::newRow("a ramp that grows") << -0.05 << 0.02;
    }
    void slowPart_isFoundFromEveryStart()
    {
        QFETCH(double, timeConstants);
        QFETCH(double, change);
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
            const auto record = recordOf(slowSum(timeConstants, change), 3000, 0.01, seed);
            std::optional<Refinement> first;
            for (const double start : {0.45, 0.03, 0.004, -0.1, 1.3, 2.0}) {
                const auto fit = refinePoles({record}, startOf(start), true);
                QVERIFY2(fit.has_value(), qPrintable(QString("start %1").arg(start)));
                QCOMPARE(fit->relaxing, std::vector<Index>{0});
                const double u = std::sqrt(fit->covariance(6, 6));
                QVERIFY(u > 3e-4 && u < 2e-3); // 0.01/sqrt(3000) for a mean, 3 to 6 times for
                                               // the end of a straight line or a parabola
                QVERIFY(std::abs(levelOf(*fit) - 1.0) < 4.0 * u);
                if (!first)
                    first = fit;
                QVERIFY(std::abs(levelOf(*first) - levelOf(*fit)) < 5e-3 * u);
            }
        }
    }

    void slowPart_withoutNoise_isExact()
    {
        for (const double timeConstants : {1.4, 0.3, 0.02, -0.2}) {
            const auto record = recordOf(slowSum(timeConstants, 0.05), 3000);
            const auto fit = refinePoles({record}, startOf(0.4), true);
            QVERIFY(fit.has_value());
            QVERIFY(std::abs(levelOf(*fit) - 1.0) < 1e-8);
            QVERIFY(std::abs(fit->poles_rad_s[0].real() * 3e-3 + timeConstants) < 1e-5);
        }
    }

    void slopeAndLevel_scatterByTheirUncertainty()
    {
        constexpr int kTrials = 200;
        constexpr double kScatter = 0.4; // as above
        Eigen::Vector2d squares = Eigen::Vector2d::Zero();
        for (int trial = 0; trial < kTrials; ++trial) {
            const auto record
                = recordOf(slowSum(0.09, 0.09), 3000, 0.01, static_cast<std::uint64_t>(trial + 10));
            const auto fit = refinePoles({record}, startOf(0.3), true);
            QVERIFY(fit.has_value());
            const double slope
                = fit->records[0].amplitudes[0].real() * fit->poles_rad_s[0].real() * 3e-3;
            const Eigen::Vector2d error(levelOf(*fit) - 1.0, (slope + 0.09) / 3e-3);
            const Eigen::Vector2d variance(fit->covariance(6, 6), fit->covariance(3, 3));
            squares += error.cwiseAbs2().cwiseQuotient(variance) / kTrials;
        }
        QVERIFY2((squares.array() - 1.0).abs().maxCoeff() < kScatter,
            qPrintable(QString("%1 %2").arg(squares[0]).arg(squares[1])));
    }

    void perturbed_ofASlowPart_movesRateSlopeAndLevel()
    {
        const auto fit
            = refinePoles({recordOf(slowSum(0.3, 0.05), 3000, 0.001)}, startOf(0.3), true);
        QVERIFY(fit.has_value());
        const double rate = fit->poles_rad_s[0].real();
        const double slope = fit->records[0].amplitudes[0].real() * rate;
        const auto levelAndSlope = [](const ExponentialSum &sum) {
            return Eigen::Vector2d(sum.constant + sum.amplitudes[0].real(),
                sum.amplitudes[0].real() * sum.poles_rad_s[0].real());
        };
        const Eigen::Vector2d before(levelOf(*fit), slope);
        // Half the rate away, on the other side of 0, and to 0 itself.
        for (const double delta : {0.5 * rate, -1.5 * rate, -rate}) {
            const ExponentialSum sum = perturbed(*fit, 0, 0, delta);
            QVERIFY(std::abs(sum.poles_rad_s[0] - rate - delta) < 1e-5 * std::abs(rate));
            QVERIFY((levelAndSlope(sum) - before).cwiseAbs().maxCoeff() < 1e-7 * std::abs(slope));
        }
        const ExponentialSum steeper = perturbed(*fit, 0, 3, 0.5);
        QVERIFY(std::abs(levelAndSlope(steeper)[1] - slope - 0.5) < 1e-9 * std::abs(slope));
        QVERIFY(std::abs(levelAndSlope(steeper)[0] - before[0]) < 1e-12);
        QVERIFY(
            std::abs(perturbed(*fit, 0, 6, 0.5).constant - fit->records[0].constant - 0.5) < 1e-12);
        // c0 and its variance: J from differences of the amplitudes, in which all is natural.
        const double u = std::sqrt(constantVariance(*fit, 0));
        Eigen::MatrixXd J(3000, 7);
        const Eigen::VectorXd size
            = (Eigen::VectorXd(7) << 1e-1, 1e1, 1e1, 1e-4, 1e-4, 1e-4, 1e-4).finished();
        for (Index i = 0; i < 7; ++i) {
            const auto moved = [&](double delta) {
                ExponentialSum sum = fit->records[0];
                if (i == 0)
                    sum.poles_rad_s[0] += delta;
                else if (i == 3)
                    sum.amplitudes[0] += delta;
                else
                    sum = perturbed(*fit, 0, i, delta);
                return sampled(sum, 3000);
            };
            J.col(i) = (moved(size[i]) - moved(-size[i])) / 2.0;
        }
        const Eigen::MatrixXd covariance = (J.transpose() * J).inverse() * 1e-6;
        const double expected = size[6] * std::sqrt(covariance(6, 6));
        QVERIFY2(std::abs(u / expected / std::max(1.0, fit->residualToNoise) - 1.0) < 1e-3,
            qPrintable(QString("%1 %2").arg(u).arg(expected)));
    }

    void growingPole_isGivenUp()
    {
        const auto growing = recordOf(pairSum({2e3, 2e5}, kAmplitude, 1.0), 800);
        QVERIFY(!refinePoles({growing}, pairOf({2e3, 2e5}), true));
        QVERIFY(!refinePoles({growing}, pairOf({-1e2, 2e5}), true));
    }

    void poleFarFromTheStart_isGivenUp()
    {
        // A real pole slides smoothly to the truth, which lies beyond the factor of 1.5.
        const auto record = recordOf(realSum(-2e4, 1.0), 1000);
        QVERIFY(refinePoles({record}, {std::complex<double>(-2.8e4)}, false).has_value());
        QVERIFY(!refinePoles({record}, {std::complex<double>(-3.2e4)}, false));
        QVERIFY(!refinePoles({record}, {std::complex<double>(-1.2e4)}, false));
    }

    void nothingToRefine_isGivenUp()
    {
        const auto record = recordOf(realSum(-2e4, 1.0), 100);
        QVERIFY(!refinePoles({record}, {}, true));
        QVERIFY(!refinePoles({record}, {std::complex<double>(0.0)}, true));
    }

    void stopRequest_endsTheFit()
    {
        std::stop_source source;
        source.request_stop();
        JobControl control;
        control.stop = source.get_token();
        const auto record = recordOf(pairSum(kPair, kAmplitude, 1.0), 800);
        QVERIFY(!refinePoles({record}, pairOf({-7e3, 2.01e5}), true, control));
    }

    void perturbed_movesTheParametersOfTheCovariance()
    {
        // J from perturbed() by differences must give back the covariance: (J^T J)^-1 / w^2.
        const auto record = recordOf(pairSum(kPair, kAmplitude, 1.0), 500);
        const auto fit = refinePoles({record}, pairOf(kPair), true);
        QVERIFY(fit.has_value());
        const Eigen::VectorXd size
            = (Eigen::VectorXd(5) << 1e5, 1e5, 1.0, 1.0, 1.0).finished() * 1e-5;
        Eigen::MatrixXd J(500, 5);
        for (Index i = 0; i < 5; ++i) {
            J.col(i) = (sampled(perturbed(*fit, 0, i, size[i]), 500)
                           - sampled(perturbed(*fit, 0, i, -size[i]), 500))
                / (2.0 * size[i]);
        }
        const Eigen::VectorXd scale = fit->covariance.diagonal().cwiseSqrt();
        const Eigen::MatrixXd scaled = J * scale.asDiagonal();
        const Eigen::MatrixXd product = (scaled.transpose() * scaled)
            * scale.cwiseInverse().asDiagonal() * fit->covariance
            * scale.cwiseInverse().asDiagonal();
        QVERIFY2((product - Eigen::MatrixXd::Identity(5, 5)).cwiseAbs().maxCoeff() < 1e-5,
            qPrintable(QString::number(
                (product - Eigen::MatrixXd::Identity(5, 5)).cwiseAbs().maxCoeff())));
    }

    void perturbed_realPoleBesideAPair_movesTheRightOne()
    {
        ExponentialSum truth = pairSum(kPair, kAmplitude, 1.0);
        truth.poles_rad_s.conservativeResize(3);
        truth.amplitudes.conservativeResize(3);
        truth.poles_rad_s[2] = -3e4;
        truth.amplitudes[2] = 0.4;
        const auto fit
            = refinePoles({recordOf(truth, 800)}, {kPair, std::conj(kPair), {-3e4, 0.0}}, true);
        QVERIFY(fit.has_value());
        const ExponentialSum &before = fit->records[0];
        QCOMPARE(perturbed(*fit, 0, 2, 7.0).poles_rad_s[2], before.poles_rad_s[2] + 7.0);
        QCOMPARE(perturbed(*fit, 0, 2, 7.0).poles_rad_s[0], before.poles_rad_s[0]);
        QCOMPARE(perturbed(*fit, 0, 6, 0.5).constant, before.constant + 0.5);
        // A real pole's amplitude is fitted as it is, only pairs are fitted as 2 Re, 2 Im.
        QCOMPARE(perturbed(*fit, 0, 5, 0.5).amplitudes[2], before.amplitudes[2] + 0.5);
        const ExponentialSum imaginary = perturbed(*fit, 0, 1, 3.0);
        QCOMPARE(imaginary.poles_rad_s[1], std::conj(imaginary.poles_rad_s[0]));
    }

    void termsOfARecordsOwn_areFittedBesideTheSharedPoles()
    {
        const std::vector<NuisanceTerm> truth{
            {0, true, {-3e3, 4e4}, {0.03, -0.02}}, {0, true, {-2e3, 4.5e4}, {-0.01, 0.04}}};
        std::vector<RefinementRecord> records;
        for (std::size_t r = 0; r < 2; ++r) {
            records.push_back(recordOf(pairSum(kPair, kAmplitude, 1.0), 1500));
            for (Index k = 0; k < 1500; ++k)
                records[r].y[k] += truth[r].value(static_cast<double>(k) / kRate_Hz);
            records[r].nuisance
                = {{0, true, truth[r].pole_rad_s * std::complex<double>(1.02), 0.0}};
        }
        const auto fit = refinePoles(records, pairOf({-7e3, 2.01e5}), true);
        QVERIFY(fit.has_value());
        QVERIFY(std::abs(fit->poles_rad_s[0] - kPair) < 1e-4 * std::abs(kPair));
        for (std::size_t r = 0; r < 2; ++r) {
            const NuisanceTerm &found = fit->nuisance[r].front();
            QVERIFY(std::abs(found.pole_rad_s - truth[r].pole_rad_s) < 1e-3 * 4e4);
            QVERIFY(std::abs(found.amplitude - truth[r].amplitude) < 1e-6);
            QVERIFY(std::abs(fit->records[r].constant - 1.0) < 1e-6);
            QVERIFY(std::abs(fit->records[r].amplitudes[0] - kAmplitude) < 1e-6);
        }
    }

    void nuisanceCovariance_matchesTheScatter()
    {
        constexpr int kTrials = 200;
        const NuisanceTerm truth{0, true, {-1e3, 4e4}, {0.05, 0.0}};
        double frequency = 0.0;
        double plateau = 0.0;
        for (int trial = 0; trial < kTrials; ++trial) {
            RefinementRecord record = recordOf(
                pairSum(kPair, kAmplitude, 1.0), 1000, 0.01, static_cast<std::uint64_t>(trial) + 1);
            for (Index k = 0; k < 1000; ++k)
                record.y[k] += truth.value(static_cast<double>(k) / kRate_Hz);
            record.nuisance = {truth};
            const auto fit = refinePoles({record}, pairOf(kPair), true);
            QVERIFY(fit.has_value());
            const Eigen::Matrix4d covariance = nuisanceCovariance(*fit, 0, 0);
            const double error = fit->nuisance[0][0].pole_rad_s.imag() - truth.pole_rad_s.imag();
            frequency += error * error / covariance(1, 1) / kTrials;
            const Eigen::MatrixXd own = recordCovariance(*fit, 0);
            const double offset = fit->records[0].constant - 1.0;
            plateau += offset * offset / own(own.rows() - 1, own.rows() - 1) / kTrials;
        }
        // 200 squares of standard normals: 1 +- 0.3 at three standard deviations.
        QVERIFY2(std::abs(frequency - 1.0) < 0.35, qPrintable(QString::number(frequency)));
        QVERIFY2(std::abs(plateau - 1.0) < 0.35, qPrintable(QString::number(plateau)));
    }

    void samplesLeftOut_takeNoPart()
    {
        RefinementRecord record = recordOf(pairSum(kPair, kAmplitude, 1.0), 1000);
        record.y.segment(100, 150).setConstant(7.0);
        record.used = {{0, 100}, {250, 1000}};
        const auto fit = refinePoles({record}, pairOf({-7e3, 2.01e5}), true);
        QVERIFY(fit.has_value());
        QVERIFY(std::abs(fit->poles_rad_s[0] - kPair) < 1e-6 * std::abs(kPair));
        QVERIFY(std::abs(fit->records[0].constant - 1.0) < 1e-8);
    }

    void recordCovariance_isTheBlockOfThatRecord()
    {
        const auto first = recordOf(pairSum(kPair, kAmplitude, 1.0), 400, 0.01, 4);
        const auto second = recordOf(pairSum(kPair, {0.3, 0.7}, -2.0), 600, 0.02, 5);
        const auto fit = refinePoles({first, second}, pairOf(kPair), true);
        QVERIFY(fit.has_value());
        QCOMPARE(fit->covariance.rows(), Index(2 + 3 + 3));
        const std::vector<Index> at{0, 1, 5, 6, 7};
        const Eigen::MatrixXd block = recordCovariance(*fit, 1);
        QCOMPARE(block.rows(), Index(5));
        for (std::size_t i = 0; i < 5; ++i) {
            for (std::size_t k = 0; k < 5; ++k)
                QCOMPARE(block(Index(i), Index(k)), fit->covariance(at[i], at[k]));
        }
        QVERIFY((block - block.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * block.maxCoeff());
    }
};

DYNCAL_TEST(TestPoleRefinement)
#include "tst_pole_refinement.moc"
