// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Amplitudes of many records at once against a QR decomposition of powers by std::pow.

#include "core/realization/exponentials/shared_fit.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <Eigen/QR>
#include <QTest>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

/// Re(x p^k) and so on, column by column, with nothing shared with the code under test.
Eigen::MatrixXd basisOf(const std::vector<Complex> &poles, Index rows, bool withConstant)
{
    std::vector<Eigen::VectorXd> columns;
    for (const Complex &p : poles) {
        if (p.imag() < 0.0)
            continue; // the lower half says the same
        Eigen::VectorXcd power(rows);
        for (Index k = 0; k < rows; ++k)
            power[k] = std::pow(p, static_cast<double>(k));
        columns.emplace_back(power.real());
        if (p.imag() > 0.0)
            columns.emplace_back(-power.imag());
    }
    if (withConstant)
        columns.emplace_back(Eigen::VectorXd::Ones(rows));
    Eigen::MatrixXd basis(rows, std::ssize(columns));
    for (Index i = 0; i < basis.cols(); ++i)
        basis.col(i) = columns[static_cast<std::size_t>(i)];
    return basis;
}

const std::vector<Complex> kPoles{
    {0.999, 0.0}, {0.8, 0.55}, {0.8, -0.55}, {-0.2, 0.97}, {-0.2, -0.97}, {-0.6, 0.0}};

} // namespace

class TestSharedFit : public QObject
{
    Q_OBJECT

private slots:
    void everyRecord_isFittedAsByQr_data()
    {
        QTest::addColumn<int>("rows");
        QTest::addColumn<bool>("withConstant");
        for (const int rows : {7, 127, 128, 129, 256, 1000}) { // powers go in stretches of 128
            QTest::addRow("%d", rows) << rows << false;
            QTest::addRow("%d with a constant", rows) << rows << true;
        }
    }
    void everyRecord_isFittedAsByQr()
    {
        QFETCH(int, rows);
        QFETCH(bool, withConstant);
        testing::Noise noise(static_cast<std::uint64_t>(rows));
        Eigen::MatrixXd records(rows, 5);
        for (Index r = 0; r < 5; ++r)
            records.col(r) = noise.series(rows, std::pow(10.0, static_cast<double>(r) * 4.0 - 8.0));
        const Eigen::MatrixXd basis = basisOf(kPoles, rows, withConstant);
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(basis);
        const auto fits = fitSharedPoles(records, kPoles, withConstant);
        QCOMPARE(fits.size(), std::size_t(5));
        for (Index r = 0; r < 5; ++r) {
            const Eigen::VectorXd expected = basis * qr.solve(records.col(r));
            const AmplitudeFit &fit = fits[static_cast<std::size_t>(r)];
            QVERIFY((fit.fitted - expected).norm() < 1e-8 * records.col(r).norm());
            // The amplitudes make up what is said to be fitted.
            Eigen::VectorXd made = Eigen::VectorXd::Constant(rows, fit.constant);
            for (Index i = 0; i < fit.amplitudes.size(); ++i) {
                for (Index k = 0; k < rows; ++k)
                    made[k] += (fit.amplitudes[i]
                        * std::pow(kPoles[static_cast<std::size_t>(i)], static_cast<double>(k)))
                                   .real();
            }
            QVERIFY((made - fit.fitted).norm() < 1e-8 * records.col(r).norm());
            QCOMPARE(fit.amplitudes[2], std::conj(fit.amplitudes[1]));
            QCOMPARE(fit.constant != 0.0, withConstant);
        }
    }

    void recordThatIsBroken_spoilsNoOther()
    {
        testing::Noise noise(5);
        Eigen::MatrixXd records(200, 3);
        for (Index r = 0; r < 3; ++r)
            records.col(r) = noise.series(200, 1.0);
        const auto whole = fitSharedPoles(records, kPoles, true);
        records(77, 1) = std::nan("");
        const auto broken = fitSharedPoles(records, kPoles, true);
        QVERIFY(!broken[1].fitted.allFinite());
        for (const std::size_t r : {std::size_t(0), std::size_t(2)})
            QVERIFY((broken[r].fitted - whole[r].fitted).norm() < 1e-12);
    }

    void sizesBeyondTheirSquares_areNoLoss()
    {
        // 1e-160 squared is below, 1e160 squared near the end of all doubles.
        for (const double size : {1e-160, 1e150}) {
            const Eigen::MatrixXd basis = basisOf(kPoles, 300, true);
            const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(basis.cols(), 0.5, 2.0);
            const auto fits = fitSharedPoles(size * (basis * x), kPoles, true);
            const Eigen::VectorXd left = fits[0].fitted / size - basis * x;
            QVERIFY2(left.norm() < 1e-9, qPrintable(QString::number(left.norm())));
        }
    }

    void vanishedPole_andEqualPoles_areFinite()
    {
        // A pole at 0 is one sample; two equal ones share their part between them.
        testing::Noise noise(9);
        const Eigen::VectorXd y = noise.series(64, 1.0);
        const auto one = fitSharedPoles(y, {{0.0, 0.0}, {0.9, 0.0}}, false);
        QVERIFY(std::abs(one[0].fitted[0] - y[0]) < 1e-9);
        const auto two = fitSharedPoles(y, {{0.9, 0.0}, {0.9, 0.0}}, false);
        const auto single = fitSharedPoles(y, {{0.9, 0.0}}, false);
        QVERIFY(two[0].amplitudes.allFinite());
        QVERIFY((two[0].fitted - single[0].fitted).norm() < 1e-6 * y.norm());
    }
};

DYNCAL_TEST(TestSharedFit)
#include "tst_shared_fit.moc"
