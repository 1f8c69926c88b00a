// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/selftest/self_check.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <new>
#include <stdexcept>

using namespace dyncal;
using testing::isNear;

namespace {

CheckSpec specOf(double (*find)(DataChange &), double expected = 12.0, double tolerance = 0.5)
{
    return {"model", {"name", {}}, {"source", {}}, expected, tolerance, find};
}

double threeSquares(DataChange &change)
{
    const double x = change(2.0);
    return 3.0 * x * x;
}

} // namespace

class TestSelfCheck : public QObject
{
    Q_OBJECT

private slots:
    void unchanged_dataAreTheSame()
    {
        DataChange none;
        const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(50, -3.0, 4.0);
        QCOMPARE(none(1.25), 1.25);
        QCOMPARE(none(values), values);
    }

    /// Every value by the share and no other, up and down, the same in every run.
    void changed_byTheShareUpOrDown()
    {
        const Eigen::VectorXd ones = Eigen::VectorXd::Ones(1000);
        const Eigen::VectorXd once = DataChange(1e-3, 7)(ones), again = DataChange(1e-3, 7)(ones);
        QCOMPARE(once, again);
        const Index up = (once.array() > 1.0).count();
        QVERIFY(up > 400 && up < 600);
        for (const double value : once)
            QVERIFY(isNear(std::abs(value - 1.0), 1e-3, 1e-9));
        QVERIFY(DataChange(1e-3, 8)(ones) != once);
    }

    void result_andItsSensitivity()
    {
        const SelfCheck check = carriedOut(specOf(threeSquares));
        QCOMPARE(check.found, 12.0);
        QVERIFY(isNear(check.sensitivity, 2.0 * 12.0 * kDataChange, 1e-3)); // d ln 3 x^2 = 2 d ln x
        QVERIFY(check.holds());
        QCOMPARE(check.step, std::string("model"));
    }

    void bounds_belongToTheTolerance()
    {
        const auto holds
            = [](double expected) { return carriedOut(specOf(threeSquares, expected)).holds(); };
        QVERIFY(holds(12.5) && holds(11.5));
        QVERIFY(!holds(12.6) && !holds(11.4));
    }

    /// What cannot be computed does not hold, whatever the tolerance.
    void nothingComputed_deviates()
    {
        const SelfCheck unknown = carriedOut(specOf([](DataChange &) { return kUnknown; }));
        QVERIFY(!unknown.holds() && std::isnan(unknown.found) && std::isnan(unknown.sensitivity));
        const SelfCheck thrown = carriedOut(
            specOf([](DataChange &) -> double { throw std::runtime_error("fault"); }, 0.0, 1e300));
        QVERIFY(!thrown.holds() && std::isnan(thrown.found));
    }

    void lackOfMemory_isNoVerdict()
    {
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc,
            carriedOut(specOf([](DataChange &) -> double { throw std::bad_alloc(); })));
    }
};

DYNCAL_TEST(TestSelfCheck)
#include "tst_self_check.moc"
