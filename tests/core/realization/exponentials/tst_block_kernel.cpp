// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/block_kernel.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cstdint>
#include <utility>

using namespace dyncal;

namespace {

constexpr Index kRows = BlockKernel::kRows;

/// Values between -1 and 1 without any pattern that sums could cancel by.
Eigen::MatrixXd values(Index rows, Index columns, int seed)
{
    Eigen::MatrixXd matrix(rows, columns);
    std::uint32_t state = static_cast<std::uint32_t>(seed) * 2654435761U + 1U;
    for (double &value : matrix.reshaped()) {
        state = state * 1664525U + 1013904223U;
        value = static_cast<double>(state) / 2147483648.0 - 1.0;
    }
    return matrix;
}

/// Sum over the rows begin, begin + step ... of a_j b_j, one after the other.
double inOrder(const Eigen::VectorXd &a, const Eigen::VectorXd &b, Index begin, Index step)
{
    double sum = 0.0;
    for (Index j = begin; j < kRows; j += step)
        sum += a[j] * b[j];
    return sum;
}

} // namespace

class TestBlockKernel : public QObject
{
    Q_OBJECT

    static void shapes()
    {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("last");
        QTest::addColumn<int>("blocks");
        for (const int blocks : {1, 2, 3, 4}) {
            for (const auto &[columns, last] :
                std::initializer_list<std::pair<int, int>>{{1, 1}, {2, 0}, {2, 2}, {5, 1}, {9, 2}})
                QTest::addRow("%d columns, %d last, %d blocks", columns, last, blocks)
                    << columns << last << blocks;
        }
    }
private slots:
    void residual_isTheRecordLessTheModel_toTheLastBit_data() { shapes(); }
    void residual_isTheRecordLessTheModel_toTheLastBit()
    {
        QFETCH(int, columns);
        QFETCH(int, last);
        QFETCH(int, blocks);
        const Eigen::MatrixXd powers = values(kRows, columns, 1);
        const Eigen::MatrixXd gains = values(columns, blocks, 2);
        const Eigen::MatrixXd y = values(kRows, blocks, 3);
        Eigen::MatrixXd residual(kRows, blocks);
        BlockKernel(powers, last).subtract(y.data(), gains, residual.data());
        for (Index b = 0; b < blocks; ++b) {
            for (Index j = 0; j < kRows; ++j) {
                double model = 0.0;
                for (Index c = 0; c < columns; ++c)
                    model += powers(j, c) * gains(c, b);
                QVERIFY(residual(j, b) == y(j, b) - model);
            }
        }
    }

    void sums_runInTheOrderStated_data() { shapes(); }
    void sums_runInTheOrderStated()
    {
        QFETCH(int, columns);
        QFETCH(int, last);
        QFETCH(int, blocks);
        const Eigen::MatrixXd powers = values(kRows, columns, 4);
        const Eigen::MatrixXd residual = values(kRows, blocks, 5);
        const Eigen::VectorXd row
            = Eigen::VectorXd::LinSpaced(kRows, 0.0, static_cast<double>(kRows - 1));
        Eigen::MatrixXd sums(2 * columns, blocks);
        BlockKernel(powers, last).project(residual.data(), sums);
        for (Index b = 0; b < blocks; ++b) {
            for (Index c = 0; c < columns; ++c) {
                const bool apart = c >= columns - last && blocks == BlockKernel::kBlocks;
                const auto sum = [&](const Eigen::VectorXd &weights) {
                    return apart ? inOrder(weights, residual.col(b), 0, 2)
                            + inOrder(weights, residual.col(b), 1, 2)
                                 : inOrder(weights, residual.col(b), 0, 1);
                };
                QVERIFY(sums(c, b) == sum(powers.col(c)));
                QVERIFY(
                    sums(columns + c, b) == sum((powers.col(c).array() * row.array()).matrix()));
            }
        }
    }

    void squares_goToFourSums()
    {
        const Eigen::VectorXd x = values(64, 1, 6);
        std::array<double, 4> sums{1.0, 2.0, 3.0, 4.0};
        addSquares(x.data(), x.size(), sums.data());
        for (std::size_t lane = 0; lane < 4; ++lane) {
            double expected = static_cast<double>(lane + 1);
            for (auto i = static_cast<Index>(lane); i < x.size(); i += 4)
                expected += x[i] * x[i];
            QVERIFY(sums[lane] == expected);
        }
    }
};

DYNCAL_TEST(TestBlockKernel)
#include "tst_block_kernel.moc"
