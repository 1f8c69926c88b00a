// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/svd.h"
#include "core/realization/hankel/hankel_operator.h"
#include "core/realization/hankel/hankel_triplets.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {
constexpr double kRounding = 1e-11; ///< of values of order one summed over some hundred terms
}

class TestHankelOperator : public QObject
{
    Q_OBJECT

private slots:
    void products_equalTheDenseMatrix_data()
    {
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("columns");
        QTest::addColumn<bool>("project");
        QTest::newRow("smallest") << 1 << 1 << false;
        QTest::newRow("one row") << 1 << 7 << true;
        QTest::newRow("tall") << 40 << 3 << true;
        QTest::newRow("wide") << 5 << 90 << false;
        QTest::newRow("square") << 64 << 64 << true;
        QTest::newRow("prime") << 101 << 53 << true;
    }
    void products_equalTheDenseMatrix()
    {
        QFETCH(int, rows);
        QFETCH(int, columns);
        QFETCH(bool, project);
        testing::Noise noise(3);
        const Eigen::VectorXd y = noise.series(rows + columns - 1, 1.0);
        const HankelOperator H(y, rows, columns, project);
        Eigen::MatrixXd dense(rows, columns);
        for (Index i = 0; i < rows; ++i) {
            for (Index j = 0; j < columns; ++j)
                dense(i, j) = y[i + j];
        }
        if (project)
            dense.colwise() -= dense.rowwise().mean().eval();
        QVERIFY((H.dense() - dense).cwiseAbs().maxCoeff() < kRounding);
        const Eigen::VectorXd x = noise.series(columns, 1.0);
        const Eigen::VectorXd z = noise.series(rows, 1.0);
        QVERIFY((H.times(x) - dense * x).cwiseAbs().maxCoeff() < kRounding);
        QVERIFY((H.transposedTimes(z) - dense.transpose() * z).cwiseAbs().maxCoeff() < kRounding);
    }

    void projection_removesAConstant()
    {
        const Eigen::VectorXd decay = testing::sampledStep(0.02, 0.1, 1.0, 120).array() - 1.0;
        const Eigen::VectorXd lifted = decay.array() + 37.5;
        const HankelOperator a(decay, 60, 61, true);
        const HankelOperator b(lifted, 60, 61, true);
        QVERIFY((a.dense() - b.dense()).cwiseAbs().maxCoeff() < kRounding);
    }

    void lanczos_agreesWithDense()
    {
        constexpr double kTenDigits = 1e-10;
        testing::Noise noise(9);
        std::vector<HankelOperator> blocks;
        Eigen::MatrixXd all(150, 0);
        for (int shot = 0; shot < 3; ++shot) {
            const Eigen::VectorXd y
                = testing::sampledStep(0.03, 0.02, 1.0, 300) + noise.series(300, 0.01);
            blocks.emplace_back(y, 150, 151, true);
            all.conservativeResize(150, all.cols() + 151);
            all.rightCols(151) = blocks.back().dense();
        }
        const ThinSvd dense = thinSvd(all);
        const auto triplets = HankelTriplets(blocks).leading(20, HankelTriplets::Right::Wanted, {});
        QVERIFY(triplets.has_value());
        for (Index k = 0; k < 20; ++k) {
            QVERIFY2(
                std::abs(triplets->singularValues[k] / dense.singularValues[k] - 1.0) < kTenDigits,
                qPrintable(QString::number(k)));
        }
        // Defining property of singular triplets: H v = sigma u.
        const Eigen::MatrixXd residual
            = all * triplets->right - triplets->left * triplets->singularValues.asDiagonal();
        QVERIFY(residual.cwiseAbs().maxCoeff() < 1e-8 * dense.singularValues[0]);
        QVERIFY(std::abs(largestSingularValue(blocks) / dense.singularValues[0] - 1.0) < 1e-4);
    }

    void lanczos_stopsOnRequest()
    {
        testing::Noise noise(1);
        std::vector<HankelOperator> blocks;
        blocks.emplace_back(noise.series(2000, 1.0), 1000, 1001, false);
        std::stop_source source;
        source.request_stop();
        const auto triplets = HankelTriplets(blocks).leading(
            40, HankelTriplets::Right::NotWanted, {source.get_token(), {}});
        QVERIFY(!triplets.has_value());
        QCOMPARE(triplets.error().kind, ErrorKind::Cancelled);
    }
};

DYNCAL_TEST(TestHankelOperator)
#include "tst_hankel_operator.moc"
