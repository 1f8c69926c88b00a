// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Complex values with their regions: closed forms, and marginals that are those stated.

#include "core/dcc/complex_region.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Row
{
    ResponseResult response;
    RowUncertainty rows;

    Row(double magnitude, double phase_rad, double u, double u_phase_rad, Eigen::RowVector3d own)
    {
        response.frequency_Hz = Eigen::VectorXd::Constant(1, 1e3);
        response.magnitude = Eigen::VectorXd::Constant(1, magnitude);
        response.phase_rad = Eigen::VectorXd::Constant(1, phase_rad);
        rows.u_magnitude = Eigen::VectorXd::Constant(1, u);
        rows.u_phase_rad = Eigen::VectorXd::Constant(1, u_phase_rad);
        rows.dof_magnitude = rows.dof_phase = Eigen::VectorXd::Constant(1, kInfinite);
        rows.covarianceReIm = own;
    }
    ComplexRegion region() const { return complexRegion(response, rows, 0); }
};

/// Standard deviation along a direction.
double along(const ComplexRegion &region, double angle_rad)
{
    const double x = std::cos(angle_rad), y = std::sin(angle_rad);
    return std::sqrt(x * x * region.varRe + 2.0 * x * y * region.covReIm + y * y * region.varIm);
}

bool isNear(double a, double b, double relative = 1e-12)
{
    return std::abs(a - b) <= relative * std::abs(b);
}

} // namespace

class TestComplexRegion : public QObject
{
    Q_OBJECT

private slots:
    /// 95 % of a plane: sqrt(-2 ln 0.05) = 2.4477; F_0.95(2, 2) = 19, so k^2 = 2 * 3 / 2 * 19 at
    /// dof 3; F_0.95(2, 10) = 4.1028 (tables).
    void factor_isThatOfHotelling()
    {
        QVERIFY(isNear(ellipseFactor(kInfinite), 2.447746830680816));
        QVERIFY(isNear(ellipseFactor(3.0), std::sqrt(57.0)));
        QVERIFY(isNear(ellipseFactor(11.0), std::sqrt(2.0 * 11.0 / 10.0 * 4.102821), 1e-6));
        QVERIFY(isNear(ellipseFactor(1e9), ellipseFactor(kInfinite), 1e-6));
        for (const double dof : {1.0, 0.5, -1.0, kUnknown})
            QVERIFY(std::isnan(ellipseFactor(dof)));
    }

    void value_isTheComplexOne()
    {
        const ComplexRegion region = Row(2.0, -M_PI / 3.0, 0.1, 0.02, {0.0, 0.0, 0.0}).region();
        QVERIFY(isNear(region.re, 1.0));
        QVERIFY(isNear(region.im, -std::sqrt(3.0)));
    }

    /// Whatever the phase: u along the value, magnitude times u(phase) across it.
    void marginals_areThoseStated()
    {
        for (const double phase_rad : {-3.0, -1.5, 0.0, 0.4, 2.0, 17.0}) {
            const ComplexRegion region = Row(5.0, phase_rad, 0.1, 0.03, {0.0, 0.0, 0.0}).region();
            QVERIFY(isNear(along(region, phase_rad), 0.1));
            QVERIFY(isNear(along(region, phase_rad + M_PI / 2.0), 0.15));
        }
    }

    /// What the row has as its own stays; only what is missing is added.
    void ownCovariance_isKept()
    {
        const Row whole(2.0, 0.0, 0.3, 0.2, {0.09, 0.012, 0.16});
        const ComplexRegion same = whole.region();
        QVERIFY(isNear(same.varRe, 0.09));
        QVERIFY(isNear(same.covReIm, 0.012));
        QVERIFY(isNear(same.varIm, 0.16));
        const ComplexRegion wider = Row(2.0, 0.0, 0.5, 0.2, {0.09, 0.012, 0.16}).region();
        QVERIFY(isNear(wider.varRe, 0.25));
        QVERIFY(isNear(wider.covReIm, 0.012));
        QVERIFY(isNear(wider.varIm, 0.16));
    }

    void region_isPositive()
    {
        for (const double cov : {-0.5, 0.0, 0.5}) {
            const ComplexRegion region = Row(3.0, 1.1, 2.0, 0.5, {1.0, cov, 1.0}).region();
            QVERIFY(region.varRe * region.varIm > region.covReIm * region.covReIm);
        }
    }

    void fewestDegreesOfFreedom_decide()
    {
        Row row(2.0, 0.0, 0.1, 0.1, {0.01, 0.0, 0.04});
        row.rows.dof_phase[0] = 3.0;
        QVERIFY(isNear(row.region().k, std::sqrt(57.0)));
        row.rows.dof_phase[0] = 1.0;
        QVERIFY(std::isnan(row.region().k));
    }

    void withheldRow_hasNothing()
    {
        const ComplexRegion none = Row(kUnknown, 0.0, 0.1, 0.1, {0.0, 0.0, 0.0}).region();
        QVERIFY(std::isnan(none.re) && std::isnan(none.varRe) && std::isnan(none.k));
    }

    void unknownUncertainty_leavesTheValue()
    {
        const ComplexRegion bare = Row(2.0, 0.0, kUnknown, 0.1, {0.0, 0.0, 0.0}).region();
        QCOMPARE(bare.re, 2.0);
        QVERIFY(std::isnan(bare.varRe) && std::isnan(bare.k));
        Row short_(2.0, 0.0, 0.1, 0.1, {0.0, 0.0, 0.0});
        short_.rows.covarianceReIm.resize(0, 3);
        QVERIFY(std::isnan(short_.region().varIm));
    }
};

DYNCAL_TEST(TestComplexRegion)
#include "tst_complex_region.moc"
