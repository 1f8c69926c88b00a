// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/eigenvalues.h"
#include "core/base/parallel.h"
#include "core/base/svd.h"
#include "core/base/tall_matrix.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <stdexcept>
#include <vector>

using namespace dyncal;

namespace {

/// Of sums of up to 20 000 products of numbers below one.
constexpr double kRounding = 1e-11;

double worst(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
{
    return (a - b).cwiseAbs().maxCoeff();
}

} // namespace

class TestTallMatrix : public QObject
{
    Q_OBJECT

private slots:
    void products_equalThoseOfEigen_data()
    {
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("few");
        for (const int rows : {1, 3, 4, 5, 511, 513, 8191, 8195, 20001}) {
            for (const int columns : {1, 3, 4, 17, 33}) {
                for (const int few : {1, 2, 3, 7})
                    QTest::addRow("%d x %d, %d", rows, columns, few) << rows << columns << few;
            }
        }
    }
    void products_equalThoseOfEigen()
    {
        QFETCH(int, rows);
        QFETCH(int, columns);
        QFETCH(int, few);
        // Blocks of larger matrices: the stride is not the number of rows.
        const Eigen::MatrixXd store = Eigen::MatrixXd::Random(rows + 3, columns + 2);
        const auto Q = store.block(2, 1, rows, columns);
        const Eigen::MatrixXd W = Eigen::MatrixXd::Random(rows, few);
        const Eigen::MatrixXd C = Eigen::MatrixXd::Random(columns, few);
        QVERIFY(worst(innerProducts(Q, W), Q.transpose() * W) < kRounding);
        Eigen::MatrixXd rest = W;
        subtractProducts(Q, C, rest);
        QVERIFY(worst(rest, W - Q * C) < kRounding);
        QVERIFY(worst(combineColumns(Q, C), Q * C) < kRounding);
        const Index kept = std::min(few, columns);
        Eigen::MatrixXd rotated = Q;
        rotateColumns(rotated, C.leftCols(kept));
        QVERIFY(worst(rotated.leftCols(kept), Q * C.leftCols(kept)) < kRounding);
    }

    void noColumns_changeNothing()
    {
        const Eigen::MatrixXd none(10, 0);
        Eigen::MatrixXd W = Eigen::MatrixXd::Ones(10, 2);
        QCOMPARE(innerProducts(none, W).rows(), Index(0));
        subtractProducts(none, Eigen::MatrixXd(0, 2), W);
        QVERIFY(W.isOnes(0.0));
    }

    void sums_ofLongMatrices_repeatToTheLastBit()
    {
        // Large enough for two threads, whose order of work differs from run to run.
        const Eigen::MatrixXd Q = Eigen::MatrixXd::Random(100'000, 20);
        const Eigen::MatrixXd W = Eigen::MatrixXd::Random(100'000, 2);
        const Eigen::MatrixXd first = innerProducts(Q, W);
        for (int run = 0; run < 10; ++run)
            QVERIFY(innerProducts(Q, W) == first);
    }

    void parts_areEachDoneOnce()
    {
        for (const bool threads : {false, true}) {
            std::vector<int> done(1000, 0);
            forEachPart(1000, threads, [&](Index part) { ++done[static_cast<std::size_t>(part)]; });
            QCOMPARE(done, std::vector<int>(1000, 1));
        }
    }

    void aProblemInAPart_reachesTheCaller()
    {
        for (const bool threads : {false, true}) {
            const auto failing = [](Index part) {
                if (part == 7)
                    throw std::runtime_error("part 7");
            };
            QVERIFY_EXCEPTION_THROWN(forEachPart(20, threads, failing), std::runtime_error);
        }
    }

    void leftSvd_equalsTheThinSvd()
    {
        for (const auto &[rows, columns] :
            {std::pair{5, 40}, std::pair{30, 30}, std::pair{40, 5}}) {
            const Eigen::MatrixXd X = Eigen::MatrixXd::Random(rows, columns);
            const LeftSvd left = leftSvd(X);
            const ThinSvd thin = thinSvd(X);
            QVERIFY(worst(left.singularValues, thin.singularValues) < 1e-13);
            // Vectors up to their sign.
            QVERIFY(worst((left.left.transpose() * thin.left).cwiseAbs(),
                        Eigen::MatrixXd::Identity(left.left.cols(), thin.left.cols()))
                < 1e-10);
        }
    }

    void symmetricEigen_diagonalises()
    {
        Eigen::MatrixXd A = Eigen::MatrixXd::Random(30, 30);
        A = (A + A.transpose()).eval();
        const SymmetricEigen eigen = symmetricEigen(A);
        QVERIFY(worst(A * eigen.vectors, eigen.vectors * eigen.values.asDiagonal()) < 1e-12);
        QVERIFY(std::is_sorted(eigen.values.begin(), eigen.values.end()));
    }
};

DYNCAL_TEST(TestTallMatrix)
#include "tst_tall_matrix.moc"
