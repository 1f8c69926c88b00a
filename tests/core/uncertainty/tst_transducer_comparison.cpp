// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Step and reference transducer on the same shots: what cancels, what does not, and the finding.

#include "core/uncertainty/transducer_comparison.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using testing::isNear;

namespace {

/// Two rows, S = `value`, noise of 0.1 %, common parts of `u` beside a chain of 1 %.
UncertainResponse answer(double value, const char *source, double u)
{
    UncertainResponse one;
    ResponseResult &r = one.response;
    r.frequency_Hz = Eigen::Vector2d(1e3, 1e4);
    r.magnitude = Eigen::Vector2d::Constant(value);
    r.u_noiseMagnitude = Eigen::Vector2d::Constant(1e-3 * value);
    r.u_frontMagnitude = r.u_referenceMagnitude = r.boundEnd = r.boundAlias
        = Eigen::Vector2d::Zero();
    r.u_magnitude = r.u_noiseMagnitude;
    r.dof = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    r.unit = "V/Pa";
    one.report.chain.ofSensitivity = {directLine("gain_relative", 0.01)};
    one.report.rows.common = {directLine("gain_relative", 0.01), directLine(source, u)};
    one.report.rows.u_common_relative = std::hypot(0.01, u);
    return one;
}

StepAgainstTransducer compared(
    const UncertainResponse &transducer, const UncertainResponse &step, double correlation = 0.0)
{
    return compareWithStep(transducer, step, correlation).value();
}

} // namespace

class TestTransducerComparison : public QObject
{
    Q_OBJECT

private slots:
    void chainOfTheDut_cancels()
    {
        const auto found = compared(
            answer(2.0, "reference_gain_relative", 0.003), answer(2.02, "velocity_m_s", 0.004));
        QVERIFY(isNear(found.difference_relative, 0.02 / 2.01, 1e-12));
        // 1 % of gain is in both; the unknown front takes nothing at these frequencies.
        const double common = std::hypot(0.003, 0.004);
        const double noise = 0.002 / 2.01; // of one row
        QVERIFY(isNear(found.u_relative, std::hypot(common, noise / std::sqrt(2.0)), 1e-4));
        QVERIFY(isNear(found.e_n[0], 0.02 / 2.01 / (2.0 * std::hypot(common, noise)), 1e-4));
        QVERIFY(isNear(found.meanE_n(), found.difference_relative / (2.0 * found.u_relative)));
    }

    void certificateOfTheReference_counts()
    {
        UncertainResponse transducer = answer(2.0, "reference_gain_relative", 0.0);
        transducer.response.u_referenceMagnitude.setConstant(0.01); // 0.5 %
        const auto found = compared(transducer, answer(2.0, "velocity_m_s", 0.0));
        QVERIFY(isNear(found.u_relative, std::hypot(0.005, 1e-3 / std::sqrt(2.0)), 1e-4));
    }

    void correlation_makesTheDifferenceSmaller()
    {
        const UncertainResponse transducer = answer(2.0, "reference_gain_relative", 0.004);
        const UncertainResponse step = answer(2.0, "velocity_m_s", 0.004);
        const double none = compared(transducer, step).u_relative;
        const double full = compared(transducer, step, 1.0).u_relative;
        QVERIFY(isNear(full, 1e-3 / std::sqrt(2.0), 1e-3)); // noise alone is left
        QVERIFY(none > 5.0 * full);
    }

    void rowsWithoutAPair_haveNone()
    {
        UncertainResponse step = answer(2.0, "velocity_m_s", 0.004);
        step.response.frequency_Hz[1] = 2e4;
        const UncertainResponse transducer = answer(2.0, "reference_gain_relative", 0.004);
        const auto found = compared(transducer, step);
        QVERIFY(std::isfinite(found.e_n[0]) && std::isnan(found.e_n[1]));
        step.response.magnitude[0] = kUnknown;
        QVERIFY(!compareWithStep(transducer, step, 0.0));
    }

    void withoutACompleteU_orInAnotherUnit_nothingIsCompared()
    {
        const UncertainResponse transducer = answer(2.0, "reference_gain_relative", 0.004);
        UncertainResponse step = answer(2.0, "velocity_m_s", 0.004);
        step.report.rows.u_common_relative = kUnknown;
        QVERIFY(!compareWithStep(transducer, step, 0.0));
        step = answer(2.0, "velocity_m_s", 0.004);
        step.response.unit = "1";
        QVERIFY(!compareWithStep(transducer, step, 0.0));
    }

    void onlyTheFlatPart_isAveraged()
    {
        UncertainResponse step = answer(2.0, "velocity_m_s", 0.004);
        step.response.magnitude[1] = 3.0; // at the resonance they may differ
        step.response.characteristics.within10percent_Hz = 5e3;
        const auto found = compared(answer(2.0, "reference_gain_relative", 0.004), step);
        QCOMPARE(found.difference_relative, 0.0);
    }

    void rows_standBesideEachOther()
    {
        ComparisonResult both;
        QVERIFY(comparedRows(both).empty());
        both.byTransducer = answer(2.0, "reference_gain_relative", 0.003);
        both.byStep = answer(2.02, "velocity_m_s", 0.004);
        both.byStep->response.frequency_Hz[1] = 2e4; // not asked for at 10 kHz
        both.againstStep = compared(*both.byTransducer, *both.byStep);
        const std::vector<ComparedRow> rows = comparedRows(both);
        QCOMPARE(rows.size(), std::size_t(2));
        QCOMPARE(rows[1].frequency_Hz, 1e4);
        QCOMPARE(rows[0].byTransducer.value, 2.0);
        QCOMPARE(rows[0].byStep.value, 2.02);
        // Gain, the transducer's own, noise: in root sum square.
        const double u = 2.0 * std::hypot(std::hypot(0.01, 0.003), 1e-3);
        QVERIFY(isNear(*rows[0].byTransducer.u, u, 1e-3));
        QCOMPARE(rows[0].e_n, both.againstStep->e_n[0]);
        QVERIFY(std::isnan(rows[1].byStep.value) && !rows[1].byStep.u);
        QVERIFY(std::isnan(rows[1].e_n));
    }

    void rows_withoutAComparison_haveNoE_n()
    {
        ComparisonResult both;
        both.byTransducer = answer(2.0, "reference_gain_relative", 0.003);
        both.byTransducer->response.magnitude[0] = kUnknown; // withheld
        both.byStep = answer(1.0, "velocity_m_s", 0.004);
        both.byStep->response.unit = "1"; // the step is not known
        std::vector<ComparedRow> rows = comparedRows(both);
        QVERIFY(std::isnan(rows[0].byTransducer.value) && !rows[0].byTransducer.u);
        QVERIFY(std::isnan(rows[1].byStep.value) && std::isnan(rows[1].e_n));
        both.byTransducer->report.rows.u_common_relative = kUnknown;
        rows = comparedRows(both);
        QVERIFY(rows[1].byTransducer.value == 2.0 && !rows[1].byTransducer.u);
    }

    void finding_beyondBothUncertainties()
    {
        QVERIFY(judgeAgainstStep({{}, 0.0199, 0.01}).empty());
        const Findings findings = judgeAgainstStep({{}, -0.0201, 0.01});
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, std::string("CMP-001"));
        QVERIFY(findings[0].severity == Severity::Caution);
        QVERIFY(findings[0].causes.front() == FindingCause::Reference);
        QVERIFY(english(findings[0].message).find("-2 %") != std::string::npos);
    }
};

DYNCAL_TEST(TestTransducerComparison)
#include "tst_transducer_comparison.moc"
