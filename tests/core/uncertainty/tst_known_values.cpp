// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of other calibrations beside this one's: closed forms of E_n, what they are compared with,
// and the reason where nothing can be compared.

#include "core/uncertainty/known_values.h"
#include "tests/support/made_comparison.h"
#include "tests/support/near.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kS0 = 2e-6; // V/Pa
constexpr double kBand_Hz = 1e3;

/// A sensitivity of 2 uV/Pa with u = 0.5 %, and S(f) 1 % higher at 10 kHz, the same u.
UncertainResponse calibrated()
{
    UncertainResponse one = testing::answerOf({kS0}, 0.005);
    one.response.fLow_Hz = kBand_Hz;
    one.response.fHigh_Hz = 1e5;
    one.report.sensitivity = ReportedValue{"sensitivity", kS0, "V/Pa"};
    one.report.sensitivity->lines = {directLine("gain_relative", 0.005 * kS0)};
    combineLines(*one.report.sensitivity);
    const UncertainResponse marks = testing::answerOf({kS0, 1.01 * kS0}, 0.005); // 1 and 10 kHz
    one.response.atMarks = std::make_shared<ResponseResult>(marks.response);
    one.report.rowsAtMarks = marks.report.rows;
    return one;
}

KnownSensitivity stated(double magnitude, double u, double f_Hz = 0.0, std::string unit = "V/Pa")
{
    return {"works", f_Hz, magnitude, u, std::move(unit), {}, "K 1"};
}

KnownValue compared(const KnownSensitivity &known, const UncertainResponse &with = calibrated())
{
    const SensorModel model = testing::secondOrderModel(5e4, 0.02);
    return compareKnown(
        {known}, with.response, with.report, {model, ResponseTreatment::StepDeflated})
        .front();
}

} // namespace

class TestKnownValues : public QObject
{
    Q_OBJECT

private slots:
    void staticValue_isComparedWithTheSensitivity()
    {
        const KnownValue found = compared(stated(1.98e-6, 0.004e-6));
        QCOMPARE(found.against, KnownAgainst::Sensitivity);
        QVERIFY(isNear(found.here.value, kS0, 1e-14));
        QVERIFY(isNear(found.difference_relative(), 0.02 / 1.98, 1e-12));
        // U of both at k = 2: 20 nV/Pa and 8 nV/Pa.
        QVERIFY(isNear(found.e_n, 0.02 / std::hypot(0.02, 0.008), 1e-9));
        QVERIFY(found.isJoined());
        QVERIFY(judgeKnown({found}).empty());
    }

    void beyondBothU_isNotJoined_andTold()
    {
        const KnownValue found = compared(stated(1.9e-6, 0.004e-6));
        QVERIFY(isNear(found.e_n, 0.1 / std::hypot(0.02, 0.008), 1e-9));
        QVERIFY(!found.isJoined());
        const Findings told = judgeKnown({found});
        QCOMPARE(told.size(), std::size_t(1));
        QCOMPARE(told.front().id, std::string("UNC-004"));
        QCOMPARE(told.front().severity, Severity::Caution);
        QVERIFY(english(told.front().message).find("works states 1.9 \xC2\xB5V/Pa") == 0);
        QVERIFY(isNear(*told.front().value, found.e_n));
    }

    void units_areConverted()
    {
        const KnownValue found = compared(stated(200.0, 1.0, 0.0, "mV/bar")); // 2 uV/Pa
        QVERIFY(isNear(found.other.value, 2e-6, 1e-12));
        QCOMPARE(found.other.unit, std::string("V/Pa"));
        QVERIFY(isNear(*found.other.u, 1e-8, 1e-12));
        QVERIFY(std::abs(found.e_n) < 1e-9);
    }

    void belowTheBand_theModelsRise_isInTheSensitivity()
    {
        const double f_Hz = 500.0, ratio = f_Hz / 5e4;
        const double rise = 1.0 / std::hypot(1.0 - ratio * ratio, 0.04 * ratio);
        const KnownValue found = compared(stated(kS0, 1e-8, f_Hz));
        QCOMPARE(found.against, KnownAgainst::Sensitivity);
        QVERIFY(isNear(found.here.value, rise * kS0, 1e-9));
        QVERIFY(isNear(*found.here.u, 0.005 * rise * kS0, 1e-9));
    }

    void inTheBand_theRowAtItsFrequency_counts()
    {
        const KnownValue found = compared(stated(kS0, 1e-8, 1e4));
        QCOMPARE(found.against, KnownAgainst::Row);
        QVERIFY(isNear(found.here.value, 1.01 * kS0, 1e-14));
        QVERIFY(isNear(found.difference_relative(), 0.01, 1e-9));
    }

    void fewDegreesOfFreedom_widenItsU()
    {
        KnownSensitivity few = stated(1.9e-6, 0.004e-6);
        few.dof = 2.0; // Student's k = 4.303
        const KnownValue found = compared(few);
        QVERIFY(isNear(found.e_n, 0.1 / std::hypot(0.02, 4.303 * 0.004), 1e-3));
    }

    void leastU_ofTheLaboratory_counts()
    {
        UncertainResponse held = calibrated();
        held.report.sensitivity->leastExpanded = 0.04 * kS0;
        combineLines(*held.report.sensitivity);
        QVERIFY(isNear(compared(stated(1.9e-6, 1e-12), held).e_n, 0.1 / 0.08, 1e-6));
    }

    void whatCannotBeCompared_hasItsReason_data()
    {
        QTest::addColumn<double>("f_Hz");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("reason");
        QTest::newRow("charge") << 0.0 << "pC/bar"
                                << "is none of V/Pa";
        QTest::newRow("no pressure") << 0.0 << "V/N"
                                     << "unit V/N";
        QTest::newRow("no ratio") << 0.0 << "V"
                                  << "unit V";
        QTest::newRow("above the band") << 2e5 << "V/Pa"
                                        << "200 kHz is above the band";
        QTest::newRow("no row there") << 2e4 << "V/Pa"
                                      << "withheld at 20 kHz";
    }
    void whatCannotBeCompared_hasItsReason()
    {
        QFETCH(double, f_Hz);
        QFETCH(QString, unit);
        QFETCH(QString, reason);
        const KnownValue found = compared(stated(1e-6, 1e-8, f_Hz, unit.toStdString()));
        QVERIFY(!found.isCompared() && !found.isJoined());
        QVERIFY2(english(found.missing).find(reason.toStdString()) != std::string::npos,
            english(found.missing).c_str());
        const Findings told = judgeKnown({found});
        QCOMPARE(told.size(), std::size_t(1));
        QCOMPARE(told.front().id, std::string("UNC-005"));
    }

    void acCoupled_hasNoStaticValue_heatedHas()
    {
        UncertainResponse drifting = calibrated();
        drifting.response.drift.kind = DriftKind::AcCoupling;
        const KnownValue found = compared(stated(kS0, 1e-8), drifting);
        QVERIFY(!found.isCompared());
        QVERIFY(english(found.missing).find("AC coupling") != std::string::npos);
        QVERIFY(compared(stated(kS0, 1e-8, 1e4), drifting).isCompared()); // in the band
        drifting.response.drift.kind = DriftKind::Heat;
        QVERIFY(compared(stated(kS0, 1e-8), drifting).isJoined());
    }

    void whatSaysNothing_isNotJoined()
    {
        for (const double u : {1e300, kS0, 0.5 * kS0}) {
            const KnownValue found = compared(stated(kS0, u));
            QVERIFY(!found.isCompared() && !found.isJoined());
            QVERIFY(english(found.missing).find("not below") != std::string::npos);
        }
        QVERIFY(compared(stated(kS0, 0.4 * kS0)).isJoined());
    }

    void withoutASensitivity_orItsU_nothingIsCompared()
    {
        UncertainResponse none = calibrated();
        none.report.sensitivity->u.reset();
        QVERIFY(!compared(stated(kS0, 1e-8), none).isCompared());
        none.report.sensitivity.reset();
        QVERIFY(!compared(stated(kS0, 1e-8), none).isCompared());
        none = calibrated();
        none.response.unit = "1";
        QVERIFY(!compared(stated(kS0, 1e-8), none).isCompared());
    }

    void order_isThatOfTheRecipe()
    {
        const UncertainResponse with = calibrated();
        const SensorModel model = testing::secondOrderModel(5e4, 0.02);
        const auto all = compareKnown({stated(kS0, 1e-8, 1e4), stated(kS0, 1e-8)}, with.response,
            with.report, {model, ResponseTreatment::StepDeflated});
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0].against, KnownAgainst::Row);
        QCOMPARE(all[1].against, KnownAgainst::Sensitivity);
    }
};

DYNCAL_TEST(TestKnownValues)
#include "tst_known_values.moc"
