// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/svd.h"
#include "core/realization/hankel/hankel_triplets.h"
#include "core/realization/hankel/lanczos.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using Right = HankelTriplets::Right;

namespace {

constexpr double kTenDigits = 1e-10;
constexpr double kOrthonormal = 1e-12; ///< a few hundred steps of full reorthogonalisation
constexpr double kResidual = 1e-8; ///< the tolerance of the iteration

/// A diagonal matrix: its eigenvalues are known, whatever their multiplicity.
class Diagonal : public SymmetricOperator
{
public:
    explicit Diagonal(Eigen::VectorXd values)
        : m_values(std::move(values))
    {
    }
    Index size() const override { return m_values.size(); }
    void apply(const Eigen::Ref<const Eigen::MatrixXd> &X, Eigen::Ref<Eigen::MatrixXd> Y) override
    {
        Y = m_values.asDiagonal() * X;
    }

private:
    Eigen::VectorXd m_values;
};

Eigen::VectorXd sortedMagnitudes(Eigen::VectorXd values)
{
    values = values.cwiseAbs();
    std::sort(values.begin(), values.end(), std::greater<>());
    return values;
}

Eigen::VectorXd noisyStep(Index samples, double noise, std::uint64_t seed)
{
    testing::Noise source(seed);
    return testing::sampledStep(0.03, 0.05, 1.0, samples) + source.series(samples, noise);
}

std::vector<HankelOperator> square(const Eigen::VectorXd &y)
{
    std::vector<HankelOperator> blocks;
    const Index rows = y.size() / 2 - 1;
    blocks.emplace_back(y, rows, rows, false);
    return blocks;
}

std::vector<HankelOperator> stacked(Index shots, Index samples, double noise)
{
    std::vector<HankelOperator> blocks;
    const Index rows = samples / 2 - 1;
    for (Index shot = 0; shot < shots; ++shot) {
        blocks.emplace_back(noisyStep(samples, noise, static_cast<std::uint64_t>(shot + 1)), rows,
            samples - rows + 1, true);
    }
    return blocks;
}

double worstRatio(const Eigen::VectorXd &found, const Eigen::VectorXd &truth)
{
    return (found.array() / truth.head(found.size()).array() - 1.0).abs().maxCoeff();
}

double lackOfOrthogonality(const Eigen::MatrixXd &U)
{
    return (U.transpose() * U - Eigen::MatrixXd::Identity(U.cols(), U.cols()))
        .cwiseAbs()
        .maxCoeff();
}

/// Largest ||H v - s u|| and ||H^T u - s v||, over s.
double worstResidual(const std::vector<HankelOperator> &blocks, const SingularTriplets &triplets)
{
    const Eigen::MatrixXd H = denseHankel(blocks);
    const auto &s = triplets.singularValues;
    const Eigen::MatrixXd left = H * triplets.right - triplets.left * s.asDiagonal();
    const Eigen::MatrixXd right = H.transpose() * triplets.left - triplets.right * s.asDiagonal();
    return std::max((left.colwise().norm().array() / s.transpose().array()).maxCoeff(),
        (right.colwise().norm().array() / s.transpose().array()).maxCoeff());
}

} // namespace

class TestLanczos : public QObject
{
    Q_OBJECT

private slots:
    void diagonal_givesItsEntries_largestMagnitudeFirst()
    {
        Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(500, -3.0, 2.0);
        values[17] = -40.0;
        values[400] = 39.0;
        Diagonal A(values);
        BlockLanczos lanczos(A);
        QVERIFY(lanczos.iterate(12, {}));
        const EigenPairs pairs = lanczos.leading(12);
        QCOMPARE(pairs.converged, Index(12));
        QVERIFY(worstRatio(pairs.values.cwiseAbs(), sortedMagnitudes(values)) < kTenDigits);
        QCOMPARE(pairs.values[0] < 0.0, true);
        QCOMPARE(pairs.values[1] > 0.0, true);
        QVERIFY(lackOfOrthogonality(pairs.vectors) < kOrthonormal);
    }

    void doubleEigenvalues_areFoundTwice()
    {
        Eigen::VectorXd values(400);
        for (Index i = 0; i < 400; ++i)
            values[i] = std::pow(0.97, static_cast<double>(i / 2)); // pairs
        Diagonal A(values);
        BlockLanczos lanczos(A);
        QVERIFY(lanczos.iterate(20, {}));
        QVERIFY(worstRatio(lanczos.leading(20).values, sortedMagnitudes(values)) < kTenDigits);
    }

    void lowRank_leavesZeros()
    {
        Eigen::VectorXd values = Eigen::VectorXd::Zero(300);
        values[3] = 5.0;
        values[200] = -2.0;
        values[299] = 1.0;
        Diagonal A(values);
        BlockLanczos lanczos(A);
        QVERIFY(lanczos.iterate(30, {}));
        const EigenPairs pairs = lanczos.leading(30);
        QCOMPARE(pairs.converged, Index(30));
        QVERIFY(worstRatio(pairs.values.head(3).cwiseAbs(), sortedMagnitudes(values)) < 1e-14);
        QVERIFY(pairs.values.tail(27).cwiseAbs().maxCoeff() < 1e-13);
        QVERIFY(lackOfOrthogonality(pairs.vectors) < kOrthonormal);
    }

    void zeroMatrix_hasZeros()
    {
        Diagonal A(Eigen::VectorXd::Zero(100));
        BlockLanczos lanczos(A);
        QVERIFY(lanczos.iterate(5, {}));
        QVERIFY(lanczos.leading(5).values.isZero(0.0));
        QVERIFY(largestSingularValue(square(Eigen::VectorXd::Zero(200))) == 0.0);
    }

    void asManyAsThereMayBe_areFound()
    {
        const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(100, 1.0, 2.0);
        Diagonal A(values);
        const Index most = BlockLanczos::mostPairs(100);
        QCOMPARE(most, Index(40));
        BlockLanczos lanczos(A);
        QVERIFY(lanczos.iterate(most, {}));
        QVERIFY(worstRatio(lanczos.leading(most).values, sortedMagnitudes(values)) < kTenDigits);
    }

    void symmetricRecord_equalsDense_data()
    {
        QTest::addColumn<double>("noise");
        QTest::newRow("noise of 1 %") << 0.01;
        QTest::newRow("noise of 1 ppm") << 1e-6;
    }
    void symmetricRecord_equalsDense()
    {
        QFETCH(double, noise);
        const auto blocks = square(noisyStep(1200, noise, 4));
        QVERIFY(blocks.front().isSymmetric());
        const ThinSvd dense = thinSvd(denseHankel(blocks));
        const auto triplets = HankelTriplets(blocks).leading(60, Right::Wanted, {});
        QCOMPARE(triplets->converged, Index(60));
        // Ten digits, but for the rounding of the FFTs, which is relative to the first value.
        const Eigen::ArrayXd allowed
            = kTenDigits * dense.singularValues.head(60).array() + 1e-15 * dense.singularValues[0];
        const Eigen::ArrayXd off
            = (triplets->singularValues - dense.singularValues.head(60)).array().abs();
        QVERIFY2((off < allowed).all(), qPrintable(QString::number((off / allowed).maxCoeff())));
        const double floor = 2e-14 * dense.singularValues[0] / dense.singularValues[59];
        QVERIFY(worstResidual(blocks, *triplets) < 2.0 * kResidual + floor);
        QVERIFY(lackOfOrthogonality(triplets->left) < kOrthonormal);
    }

    void stackedShots_equalDense()
    {
        const auto blocks = stacked(3, 1000, 0.01);
        const ThinSvd dense = thinSvd(denseHankel(blocks));
        const auto triplets = HankelTriplets(blocks).leading(120, Right::Wanted, {});
        QCOMPARE(triplets->converged, Index(120));
        QVERIFY(worstRatio(triplets->singularValues, dense.singularValues) < kTenDigits);
        // Of the squared matrix's eigenpairs, taken back to H: one factor s larger at most.
        QVERIFY(worstResidual(blocks, *triplets) < 10.0 * kResidual);
        QVERIFY(lackOfOrthogonality(triplets->left) < kOrthonormal);
    }

    void noiseFreeRecord_hasItsRankAndNoMore()
    {
        const auto triplets
            = HankelTriplets(square(noisyStep(2000, 0.0, 1))).leading(20, Right::NotWanted, {});
        const Eigen::VectorXd &s = triplets->singularValues;
        QVERIFY(s[2] > 1e-3 * s[0]); // step and resonance
        QVERIFY(s[3] < 1e-13 * s[0]);
    }

    void goingOn_givesWhatAFreshStartGives()
    {
        const auto blocks = stacked(2, 1500, 0.01);
        HankelTriplets stages(blocks);
        const auto few = stages.leading(30, Right::NotWanted, {});
        const auto more = stages.leading(100, Right::NotWanted, {});
        const auto fresh = HankelTriplets(blocks).leading(100, Right::NotWanted, {});
        QVERIFY(worstRatio(few->singularValues, fresh->singularValues) < kTenDigits);
        QVERIFY(worstRatio(more->singularValues, fresh->singularValues) < kTenDigits);
    }

    void sameRecord_givesTheSameBits()
    {
        const auto blocks = stacked(2, 1500, 0.01);
        const auto first = HankelTriplets(blocks).leading(30, Right::NotWanted, {});
        const auto second = HankelTriplets(blocks).leading(30, Right::NotWanted, {});
        QVERIFY(first->singularValues == second->singularValues);
        QVERIFY(first->left == second->left);
    }

    void largestValue_isGoodToOnePerCent()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            testing::Noise source(seed); // no value stands out: the slowest case
            const auto blocks = square(source.series(600, 1.0));
            const double truth = thinSvd(denseHankel(blocks)).singularValues[0];
            const double found = largestSingularValue(blocks);
            QVERIFY2(
                std::abs(found / truth - 1.0) < 0.01, qPrintable(QString::number(found / truth)));
        }
    }

    void progress_movesForwardOnly()
    {
        std::vector<double> seen;
        const JobControl control{{}, [&](double fraction) { seen.push_back(fraction); }};
        QVERIFY(HankelTriplets(stacked(1, 1500, 0.01)).leading(60, Right::NotWanted, control));
        QVERIFY(seen.size() > 20);
        QVERIFY(std::is_sorted(seen.begin(), seen.end()));
        QVERIFY(seen.front() >= 0.0 && seen.back() < 1.0);
    }

    void stopRequest_endsWithinAStep()
    {
        std::stop_source source;
        Index reports = 0;
        const JobControl control{source.get_token(), [&](double) {
                                     if (++reports == 5)
                                         source.request_stop();
                                 }};
        const auto triplets
            = HankelTriplets(stacked(1, 1500, 0.01)).leading(60, Right::NotWanted, control);
        QVERIFY(!triplets);
        QCOMPARE(triplets.error().kind, ErrorKind::Cancelled);
        QCOMPARE(reports, Index(5));
    }
};

DYNCAL_TEST(TestLanczos)
#include "tst_lanczos.moc"
