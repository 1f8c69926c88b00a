// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/eigenvalues.h"
#include "core/base/least_squares.h"
#include "core/base/svd.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <vector>

using namespace dyncal;

namespace {

constexpr double kExact = 1e-12; ///< a few hundred roundings of numbers of order one

Eigen::MatrixXd randomMatrix(Index rows, Index columns, std::uint64_t seed)
{
    testing::Noise noise(seed);
    return Eigen::Map<const Eigen::MatrixXd>(
        noise.series(rows * columns, 1.0).eval().data(), rows, columns)
        .eval();
}

double largest(const Eigen::MatrixXd &matrix)
{
    return matrix.cwiseAbs().maxCoeff();
}

} // namespace

class TestSvd : public QObject
{
    Q_OBJECT

private slots:
    void thinSvd_factorsReproduceTheMatrix()
    {
        for (const auto &[rows, columns] :
            {std::pair<Index, Index>{30, 12}, {12, 30}, {7, 7}, {1, 5}, {5, 1}}) {
            const Eigen::MatrixXd X = randomMatrix(rows, columns, 3);
            const ThinSvd svd = thinSvd(X);
            const Index k = std::min(rows, columns);
            QCOMPARE(svd.left.rows(), rows);
            QCOMPARE(svd.right.rows(), columns);
            QCOMPARE(svd.left.cols(), k);
            QCOMPARE(svd.right.cols(), k);
            const Eigen::MatrixXd back
                = svd.left * svd.singularValues.asDiagonal() * svd.right.transpose();
            QVERIFY(largest(back - X) < kExact);
            const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(k, k);
            QVERIFY(largest(svd.left.transpose() * svd.left - one) < kExact);
            QVERIFY(largest(svd.right.transpose() * svd.right - one) < kExact);
            QVERIFY(std::is_sorted(
                svd.singularValues.begin(), svd.singularValues.end(), std::greater<>()));
        }
    }

    void thinSvd_ofKnownSingularValues_findsThem()
    {
        // Orthogonal factors from an SVD of noise, singular values over fourteen decades.
        const Eigen::MatrixXd U = thinSvd(randomMatrix(40, 8, 1)).left;
        const Eigen::MatrixXd V = thinSvd(randomMatrix(20, 8, 2)).left;
        Eigen::VectorXd s(8);
        s << 1e6, 1e4, 10.0, 9.9999, 1.0, 1e-3, 1e-8, 0.0;
        const Eigen::VectorXd found
            = thinSvd(U * s.asDiagonal() * V.transpose()).singularValues.head(8);
        QVERIFY((found - s).cwiseAbs().maxCoeff() < kExact * s[0]);
    }

    void eigenvalues_ofACompanionMatrix_areTheRoots()
    {
        // (x - 0.5)(x + 2)(x^2 + 1) = x^4 + 1.5 x^3 + 1.5 x - 1
        Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(4, 4);
        companion.row(0) << -1.5, 0.0, -1.5, 1.0;
        companion.diagonal(-1).setOnes();
        const Eigen::VectorXcd found = eigenvalues(companion);
        for (const std::complex<double> root :
            {std::complex<double>(0.5), {-2.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
            QVERIFY((found.array() - root).abs().minCoeff() < kExact);
    }

    void leastSquares_meetsTheNormalEquations()
    {
        const Eigen::MatrixXd A = randomMatrix(50, 6, 5);
        const Eigen::MatrixXd B = randomMatrix(50, 2, 6);
        const Eigen::MatrixXd X = leastSquares(A, B);
        QVERIFY(largest(A.transpose() * (A * X - B)) < kExact);
        QVERIFY(largest(leastSquares(A, Eigen::MatrixXd(A * X)) - X) < kExact);
    }

    void leastSquares_complex_recoversTheSolution()
    {
        Eigen::MatrixXcd A(40, 4);
        A.real() = randomMatrix(40, 4, 7);
        A.imag() = randomMatrix(40, 4, 8);
        Eigen::MatrixXcd X(4, 1);
        X << std::complex<double>(1.0, 2.0), std::complex<double>(-3.0, 0.5), 0.0,
            std::complex<double>(0.0, -1.0);
        QVERIFY((leastSquares(A, Eigen::MatrixXcd(A * X)) - X).cwiseAbs().maxCoeff() < kExact);
    }

    void leastSquares_dependentColumns_staysFiniteAndFits()
    {
        Eigen::MatrixXd A = randomMatrix(30, 4, 9);
        A.col(3) = A.col(0);
        const Eigen::MatrixXd B = A * Eigen::VectorXd::Ones(4);
        const Eigen::MatrixXd X = leastSquares(A, B);
        QVERIFY(X.allFinite());
        QVERIFY(largest(A * X - B) < kExact);
        QVERIFY(largest(X) < 10.0); // not two huge numbers of opposite sign
    }
};

DYNCAL_TEST(TestSvd)
#include "tst_svd.moc"
