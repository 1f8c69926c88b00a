// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/eigenvalues.h"
#include "core/base/least_squares.h"
#include "core/base/svd.h"
#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/hankel/realized_poles.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kExact = 1e-10; ///< relative to the largest singular value

ModelInput shots(Index count, Index samples, double noise, std::uint64_t seed = 1)
{
    testing::Noise source(seed);
    std::vector<ModelSeries> series;
    for (Index shot = 1; shot <= count; ++shot) {
        const double sd = noise * static_cast<double>(shot);
        const Eigen::VectorXd y
            = testing::sampledStep(40e3, 0.04, kRate_Hz, samples, 0.3 * static_cast<double>(shot))
            + source.series(samples, sd);
        series.push_back(testing::makeSeries(shot, y, kRate_Hz, source.series(20000, sd)));
    }
    return testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz, std::move(series));
}

/// The matrix written out: each row without its mean, blocks side by side, each over its weight.
Eigen::MatrixXd stackedHankel(
    const ModelInput &input, Index rows, const std::vector<double> &weights)
{
    const Index columns = input.samples - rows + 1;
    Eigen::MatrixXd H(rows, columns * static_cast<Index>(input.series.size()));
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        Eigen::MatrixXd block(rows, columns);
        for (Index i = 0; i < rows; ++i)
            block.row(i) = input.series[r].y.segment(i, columns).transpose() / weights[r];
        block.colwise() -= block.rowwise().mean().eval();
        H.middleCols(columns * static_cast<Index>(r), columns) = block;
    }
    return H;
}

double worst(const Eigen::VectorXd &found, const Eigen::VectorXd &truth)
{
    return (found - truth).cwiseAbs().maxCoeff() / truth[0];
}

/// Noise x_k = 0.9 x_(k-1) + e_k of standard deviation `sd`, started in its stationary state.
Eigen::VectorXd colouredNoise(testing::Noise &source, Index count, double sd)
{
    Eigen::VectorXd x = source.series(count, sd);
    for (Index k = 1; k < count; ++k)
        x[k] = 0.9 * x[k - 1] + std::sqrt(1.0 - 0.81) * x[k];
    return x;
}

} // namespace

class TestHankelDecomposition : public QObject
{
    Q_OBJECT

private slots:
    void stackedShots_areWeightedByTheirNoise()
    {
        const ModelInput input = shots(3, 200, 0.01);
        const auto hankel = decomposeHankel(input, {});
        QVERIFY(hankel.has_value());
        QCOMPARE(hankel->method, std::string("dense"));
        QVERIFY(hankel->onesProjected);
        QCOMPARE(hankel->rows, Index(99));
        QCOMPARE(hankel->columns, Index(3 * 102));
        for (std::size_t r = 0; r < 3; ++r)
            QCOMPARE(hankel->seriesWeights[r], input.series[r].noiseSd);
        const Eigen::VectorXd truth
            = thinSvd(stackedHankel(input, 99, hankel->seriesWeights)).singularValues;
        QVERIFY(worst(hankel->singularValues, truth.head(hankel->singularValues.size())) < kExact);
    }

    void oneShot_isNotScaled()
    {
        const ModelInput input = shots(1, 200, 0.01);
        QCOMPARE(decomposeHankel(input, {})->seriesWeights, std::vector<double>{1.0});
    }

    void rows_areThoseAskedFor()
    {
        const ModelInput input = shots(2, 200, 0.01);
        for (const Index rows : {Index(2), Index(40), Index(150), Index(198)}) {
            RealizationSettings settings;
            settings.rows = rows;
            const auto hankel = decomposeHankel(input, settings);
            QVERIFY(hankel.has_value());
            QCOMPARE(hankel->rows, rows);
            QCOMPARE(hankel->columns, 2 * (200 - rows + 1));
            const Eigen::VectorXd truth
                = thinSvd(stackedHankel(input, rows, hankel->seriesWeights)).singularValues;
            const Index kept = hankel->singularValues.size();
            QVERIFY(worst(hankel->singularValues, truth.head(kept)) < kExact);
        }
    }

    void maxOrder_boundsWhatIsKept()
    {
        RealizationSettings settings;
        settings.maxOrder = 7;
        const auto hankel = decomposeHankel(shots(1, 200, 0.01), settings);
        QCOMPARE(hankel->singularValues.size(), Index(7));
        QCOMPARE(hankel->leftVectors.cols(), Index(7));
        QCOMPARE(largestOrder(*hankel), Index(7));
    }

    void lanczos_equalsTheDenseDecomposition()
    {
        const ModelInput input = shots(1, 1000, 0.01);
        RealizationSettings settings;
        settings.maxOrder = 20;
        const auto hankel = decomposeHankel(input, settings);
        QVERIFY(hankel.has_value());
        QCOMPARE(hankel->method, std::string("lanczos"));
        const Eigen::VectorXd truth
            = thinSvd(stackedHankel(input, hankel->rows, {1.0})).singularValues.head(20);
        QVERIFY2(worst(hankel->singularValues, truth) < kExact,
            qPrintable(QString::number(worst(hankel->singularValues, truth))));
        const Eigen::MatrixXd gram = hankel->leftVectors.transpose() * hankel->leftVectors;
        QVERIFY((gram - Eigen::MatrixXd::Identity(20, 20)).cwiseAbs().maxCoeff() < 1e-9);
    }

    void noiseFloor_holdsNoiseOfItsOwnKind()
    {
        // Pure noise of the same level stays below its 95 % point nearly always.
        int below = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            testing::Noise source(seed);
            const Eigen::VectorXd y = source.series(200, 0.01);
            const ModelInput input = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz,
                {testing::makeSeries(1, y, kRate_Hz, source.series(20000, 0.01))});
            const auto hankel = decomposeHankel(input, {});
            below += hankel->singularValues[0] < hankel->noiseFloor_p95;
            QVERIFY(hankel->noiseFloor_median > 0.0);
            QVERIFY(hankel->noiseFloor_median < hankel->noiseFloor_p95);
        }
        qInfo("%d of 40 below the floor", below);
        QVERIFY(
            below >= 32); // binomial, 12 draws each: 95 % less four sd of 40 and of the estimate
    }

    void noiseFloor_withoutALongRecord_isTheFormula()
    {
        ModelInput input = shots(1, 200, 0.01);
        ModelSeries &series = input.series[0];
        series.noise = series.noise.head(150).eval();
        const auto hankel = decomposeHankel(input, {});
        const double m = std::sqrt(99.0 * 102.0);
        const double formula = 0.75 * series.noiseSd * std::sqrt(2.0 * m * std::log(m));
        QVERIFY(std::abs(hankel->noiseFloor_p95 / formula - 1.0) < 1e-12);
        // The formula stands in for the draws: it must be of their size.
        const double drawn = decomposeHankel(shots(1, 200, 0.01), {})->noiseFloor_p95;
        QVERIFY2(
            std::abs(drawn / formula - 1.0) < 0.35, qPrintable(QString::number(drawn / formula)));
    }

    void leadingBlocks_equalAFreshShiftInvariance()
    {
        const auto hankel = decomposeHankel(shots(2, 200, 0.01), {});
        for (const Index n : {Index(1), Index(2), Index(3), Index(8), Index(30)}) {
            const Eigen::MatrixXd U = hankel->leftVectors.leftCols(n);
            const Eigen::MatrixXd A
                = leastSquares(Eigen::MatrixXd(U.topRows(98)), Eigen::MatrixXd(U.bottomRows(98)));
            const Eigen::VectorXcd fresh = eigenvalues(A);
            const auto poles = realizedPoles(*hankel, n);
            QCOMPARE(Index(poles.size()), n);
            for (const std::complex<double> &z : poles)
                QVERIFY((fresh.array() - z).abs().minCoeff() < 1e-8);
        }
    }

    void noiseFree_orderTwo_givesThePole()
    {
        const auto poles = realizedPoles(*decomposeHankel(shots(1, 200, 0.0), {}), 2);
        QVERIFY(std::abs(poles[0] - testing::secondOrderPole(40e3, 0.04, kRate_Hz)) < 1e-9);
        QCOMPARE(poles[1], std::conj(poles[0]));
    }

    void suggestion_inColouredNoise_isTheTrueOrder()
    {
        // AR(0.9) noise has a pole of its own: without whitening it would be taken for the
        // sensor's.
        int right = 0;
        int rightUnwhitened = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            testing::Noise source(seed);
            const Eigen::VectorXd y = testing::sampledStep(60e3, 0.03, kRate_Hz, 300)
                + colouredNoise(source, 300, 0.01);
            ModelInput input = testing::makeInput(ResponseTreatment::StepDeflated, kRate_Hz,
                {testing::makeSeries(1, y, kRate_Hz, colouredNoise(source, 5000, 0.01))});
            right += suggestOrder(input, *decomposeHankel(input, {})).order == 2;
            input.series[0].noise.resize(0);
            rightUnwhitened += suggestOrder(input, *decomposeHankel(input, {})).order == 2;
        }
        qInfo("%d of 20 right, %d without whitening", right, rightUnwhitened);
        QVERIFY(right >= 18);
        QVERIFY(rightUnwhitened < right); // the case needs the whitening
    }

    void suggestion_ofANoiseFreeThirdOrder_isThree()
    {
        Eigen::VectorXd y = testing::sampledStep(60e3, 0.03, kRate_Hz, 300);
        for (Index k = 0; k < 300; ++k)
            y[k] -= 0.3 * std::exp(-4e4 * static_cast<double>(k + 1) / kRate_Hz);
        const ModelInput input = testing::makeInput(
            ResponseTreatment::StepDeflated, kRate_Hz, {testing::makeSeries(1, y, kRate_Hz)});
        const OrderSuggestion suggestion = suggestOrder(input, *decomposeHankel(input, {}));
        QCOMPARE(suggestion.order, Index(3));
        QCOMPARE(suggestion.bic.size(), Index(20));
        QVERIFY(english(suggestion.reason).starts_with("Order 3 has the smallest BIC"));
        for (Index n = 1; n <= 20; ++n)
            QVERIFY(n == 3 || suggestion.bic[n - 1] > suggestion.bic[2]);
    }
};

DYNCAL_TEST(TestHankelDecomposition)
#include "tst_hankel_decomposition.moc"
