// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A reference transducer's sensitivity: between the rows of its table, outside them, and the
// second-order sensor in closed form.

#include "core/reference/reference_sensitivity.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace dyncal;
using testing::isNear;

namespace {

std::vector<ReferencePoint> twoRows()
{
    return {{100.0, 2e-8, 1e-10, -0.1, 0.01, 12.0}, {10000.0, 4e-8, 3e-10, -0.3, 0.03}};
}

std::string faultOfTable(std::vector<ReferencePoint> rows)
{
    const auto made = ReferenceSensitivity::fromTable(std::move(rows));
    return made ? std::string() : english(made.error().message);
}

} // namespace

class TestReferenceSensitivity : public QObject
{
    Q_OBJECT

private slots:
    void table_isStraightOverLogFrequency()
    {
        const auto table = ReferenceSensitivity::fromTable(twoRows()).value();
        const ReferencePoint middle = table.at(1000.0).value();
        QVERIFY(isNear(middle.magnitude, 3e-8));
        // Nobody knows how two rows alone are joined: half of their difference, a rectangle.
        QVERIFY(isNear(middle.u_magnitude, std::hypot(2e-10, 1e-8 / std::sqrt(3.0))));
        QVERIFY(isNear(middle.phase_rad, -0.2));
        QVERIFY(isNear(middle.u_phase_rad, std::hypot(0.02, 0.1 / std::sqrt(3.0))));
        QCOMPARE(middle.dof, 12.0); // the fewer of the two
        QCOMPARE(table.at(100.0)->magnitude, 2e-8);
        QCOMPARE(table.at(10000.0)->magnitude, 4e-8);
        QCOMPARE(table.lowest().magnitude, 2e-8);
    }

    /// Of a parabola over log f twice what the line misses, of a straight one nothing.
    void whatALineMisses_isInTheU()
    {
        for (const double bend : {0.0, 0.04}) {
            std::vector<ReferencePoint> rows;
            for (int x = 0; x < 5; ++x)
                rows.push_back({std::exp(x), 1.0 + 0.1 * x + 0.5 * bend * x * x, 0.002});
            const auto table = ReferenceSensitivity::fromTable(rows).value();
            for (double x = 0.0; x <= 4.0; x += 0.125) {
                const ReferencePoint point = table.at(std::exp(x)).value();
                const double truth = 1.0 + 0.1 * x + 0.5 * bend * x * x;
                const double missed = 2.0 * (point.magnitude - truth);
                QVERIFY(
                    isNear(point.u_magnitude, std::hypot(0.002, missed / std::sqrt(3.0)), 1e-9));
                QVERIFY(std::isnan(point.u_phase_rad));
            }
        }
    }

    /// One row a decade of an amplifier with one pole: the truth lies within what is stated.
    void coarseTable_saysHowCoarse()
    {
        const auto amplifier = [](double f_Hz) { return 1.0 / std::hypot(1.0, f_Hz / 2e6); };
        std::vector<ReferencePoint> rows;
        for (const double f_Hz : {1e2, 1e3, 1e4, 1e5, 1e6, 1e7})
            rows.push_back({f_Hz, amplifier(f_Hz), 1e-4, -std::atan(f_Hz / 2e6), 1e-4});
        const auto table = ReferenceSensitivity::fromTable(rows).value();
        double largest = 0.0;
        for (double f_Hz = 1e2; f_Hz < 1e7; f_Hz *= 1.1) {
            const ReferencePoint point = table.at(f_Hz).value();
            const double off = std::abs(point.magnitude - amplifier(f_Hz));
            QVERIFY(off <= 2.0 * point.u_magnitude);
            QVERIFY(std::abs(point.phase_rad + std::atan(f_Hz / 2e6)) <= 2.0 * point.u_phase_rad);
            largest = std::max(largest, off);
        }
        QVERIFY(largest > 0.03);
    }

    /// In other units and at other frequencies the same shares of the way.
    void table_scalesWithItsUnits()
    {
        constexpr double kUnit = 1e6;
        auto rows = twoRows();
        for (ReferencePoint &row : rows) {
            row.magnitude *= kUnit;
            row.u_magnitude *= kUnit;
            row.frequency_Hz *= kUnit;
        }
        const auto one = ReferenceSensitivity::fromTable(twoRows()).value();
        const auto other = ReferenceSensitivity::fromTable(rows).value();
        for (const double f_Hz : {100.0, 150.0, 999.0, 1e4}) {
            const ReferencePoint a = one.at(f_Hz).value(), b = other.at(kUnit * f_Hz).value();
            QVERIFY(isNear(b.magnitude, kUnit * a.magnitude));
            QVERIFY(isNear(b.u_magnitude, kUnit * a.u_magnitude));
            QVERIFY(isNear(b.phase_rad, a.phase_rad));
        }
    }

    void table_isNotExtrapolated()
    {
        const auto table = ReferenceSensitivity::fromTable(twoRows()).value();
        QVERIFY(!table.at(99.9) && !table.at(10001.0) && !table.at(std::nan("")));
        QVERIFY(table.at(100.0 * (1.0 - 1e-12)) && table.at(10000.0 * (1.0 + 1e-12)));
        QCOMPARE(table.lowest_Hz(), 100.0);
        QCOMPARE(table.highest_Hz(), 10000.0);
    }

    /// Of 1 + a f^2 the change down to 0 is a f_1^2, whichever rows show it.
    void changeBelow_isThatOfAnEvenFunction()
    {
        const auto rowsOf = [](const std::vector<double> &frequencies_Hz) {
            std::vector<ReferencePoint> rows;
            for (const double f_Hz : frequencies_Hz)
                rows.push_back({f_Hz, 2e-8 * (1.0 + 1e-10 * f_Hz * f_Hz), 1e-10});
            return ReferenceSensitivity::fromTable(rows).value();
        };
        for (const auto &list :
            {std::vector<double>{1e4, 1.5e4, 2e4, 5e4}, {1e4, 3e4}, {1e4, 1.2e4}})
            QVERIFY(isNear(rowsOf(list).changeBelow(), 2e-8 * 1e-10 * 1e8, 1e-9));
        QVERIFY(std::isnan(rowsOf({1e4}).changeBelow()));
        QCOMPARE(ReferenceSensitivity::fromModel({2e-8, 1e-10, 4e5, 4e3, 0.3, 0.01})
                     .value()
                     .changeBelow(),
            0.0);
    }

    void table_mayHaveNoPhase()
    {
        const auto table
            = ReferenceSensitivity::fromTable({{100.0, 2e-8, 0.0}, {200.0, 2e-8, 0.0}}).value();
        QVERIFY(std::isnan(table.at(150.0)->phase_rad));
        QCOMPARE(table.at(150.0)->magnitude, 2e-8);
    }

    void malformedRows_areNamed()
    {
        QVERIFY(!faultOfTable({}).empty());
        auto rows = twoRows();
        rows[1].frequency_Hz = 100.0;
        QVERIFY(faultOfTable(rows).find("Row 2") != std::string::npos);
        rows = twoRows();
        rows[0].magnitude = 0.0;
        QVERIFY(faultOfTable(rows).find("magnitude above 0") != std::string::npos);
        rows = twoRows();
        rows[1].u_magnitude = -1.0;
        QVERIFY(!faultOfTable(rows).empty());
        rows = twoRows();
        rows[1].phase_rad = std::nan("");
        QVERIFY(faultOfTable(rows).find("in all rows, or in none") != std::string::npos);
        rows = twoRows();
        rows[1].dof = 0.0;
        QVERIFY(!faultOfTable(rows).empty());
        rows[1].frequency_Hz = std::numeric_limits<double>::infinity();
        QVERIFY(!faultOfTable(rows).empty());
    }

    /// A line between -3.1 and 3.1 rad would cross 0.
    void wrappedPhase_isNamed()
    {
        std::vector<ReferencePoint> rows{
            {100.0, 1.0, 0.01, -3.0, 0.01}, {200.0, 1.0, 0.01, 3.0, 0.01}};
        QVERIFY(faultOfTable(rows).find("half a turn") != std::string::npos);
        rows[1].phase_rad -= 2.0 * std::numbers::pi;
        QVERIFY(faultOfTable(rows).empty());
    }

    void model_isTheSecondOrderSensor()
    {
        const ReferenceModel model{2e-8, 1e-10, 3e5, 300.0, 0.1, 0.002};
        const auto made = ReferenceSensitivity::fromModel(model).value();
        for (const double f_Hz : {1e3, 1e5, 2.9e5, 4e5}) {
            const double r = f_Hz / model.f0_Hz;
            const std::complex<double> D(1.0 - r * r, 2.0 * model.zeta * r);
            const ReferencePoint point = made.at(f_Hz).value();
            QVERIFY(isNear(point.magnitude, 2e-8 / std::abs(D), 1e-12));
            QVERIFY(std::abs(point.phase_rad + std::arg(D)) < 1e-12);
            // d ln S = dS0/S0 + (2 r^2 - 2 j zeta r)... of D by f0, and -2 j r/D by zeta.
            const std::complex<double> byF0
                = -(std::complex<double>(2.0 * r * r, -2.0 * 0.1 * r)) / D;
            const std::complex<double> byZeta = -std::complex<double>(0.0, 2.0 * r) / D;
            const double along = std::hypot(0.005, 0.001 * byF0.real(), 0.002 * byZeta.real());
            const double across = std::hypot(0.001 * byF0.imag(), 0.002 * byZeta.imag());
            QVERIFY(isNear(point.u_magnitude / point.magnitude, along, 1e-5));
            QVERIFY(isNear(point.u_phase_rad, across, 1e-5));
        }
        QCOMPARE(made.lowest().magnitude, 2e-8);
        QVERIFY(isNear(made.lowest().u_magnitude, 1e-10, 1e-4));
    }

    void impossibleModels_areRefused()
    {
        for (const ReferenceModel &model : {ReferenceModel{0.0, 0.0, 1e5, 0.0, 0.1, 0.0},
                 ReferenceModel{1.0, -1.0, 1e5, 0.0, 0.1, 0.0},
                 ReferenceModel{1.0, 0.0, 1e5, 0.0, 0.0, 0.0}}) {
            const auto made = ReferenceSensitivity::fromModel(model);
            QVERIFY(!made && made.error().kind == ErrorKind::Usage);
        }
    }

    void uncertaintiesThatAreNotKnown_areFound()
    {
        auto rows = twoRows();
        QVERIFY(!ReferenceSensitivity::fromTable(rows)->withoutU_Hz());
        rows[1].u_phase_rad = 0.0;
        QCOMPARE(*ReferenceSensitivity::fromTable(rows)->withoutU_Hz(), 10000.0);
        rows[0].u_magnitude = 1e-13 * rows[0].magnitude;
        QCOMPARE(*ReferenceSensitivity::fromTable(rows)->withoutU_Hz(), 100.0);
        QVERIFY(!ReferenceSensitivity::fromTable({{1.0, 2.0, 0.1}})->withoutU_Hz());
        const ReferenceModel known{1e-5, 1e-8, 1e6, 1e3, 0.1, 1e-3};
        QVERIFY(!ReferenceSensitivity::fromModel(known)->withoutU_Hz());
        for (double ReferenceModel::*u :
            {&ReferenceModel::u_sensitivity, &ReferenceModel::u_f0_Hz, &ReferenceModel::u_zeta}) {
            ReferenceModel model = known;
            model.*u = 0.0;
            QCOMPARE(*ReferenceSensitivity::fromModel(model)->withoutU_Hz(), 0.0);
        }
    }
};

DYNCAL_TEST(TestReferenceSensitivity)
#include "tst_reference_sensitivity.moc"
