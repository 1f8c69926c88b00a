// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The laboratory's least uncertainty: never stated less, and nothing else changed.

#include "core/pipeline/pipeline.h"
#include "core/uncertainty/budgets.h"
#include "core/uncertainty/capability.h"
#include "tests/support/near.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

CapabilityEntry relative(
    const char *of, double U, double from_Hz = 0.0, std::optional<double> to_Hz = {})
{
    return {of, U, true, from_Hz, to_Hz};
}

ReportedValue value(double u, double dof, double least)
{
    ReportedValue reported{"f0_hz", 100.0, "Hz", {directLine("noise", u, dof)}};
    reported.leastExpanded = least;
    combineLines(reported);
    return reported;
}

const std::vector<CapabilityEntry> kAll{relative("sensitivity", 0.03),
    relative("magnitude", 0.05, 0.0, 1e4), relative("magnitude", 0.04), relative("f0_hz", 0.02),
    {"phase_rad", 0.05}};

} // namespace

class TestCapability : public QObject
{
    Q_OBJECT

private:
    CalibrationResults m_results;

private slots:
    void initTestCase()
    {
        ResultCache cache;
        Recipe recipe;
        recipe.uncertainty.cmc = kAll;
        m_results = runPipeline(testing::simulatedExample(2e7), recipe, cache, StageId::Uncertainty)
                        .results;
    }

    /// With u known exactly the line is the root of (U/2)^2 - u^2.
    void knownU_closedForm()
    {
        const ReportedValue raised = value(0.3, std::numeric_limits<double>::infinity(), 1.0);
        QCOMPARE(raised.lines.size(), 2);
        QCOMPARE(raised.lines.back().quantity, kCapability);
        QVERIFY(isNear(raised.lines.back().contribution, 0.4));
        QVERIFY(isNear(*raised.expanded(), 1.0));
        QVERIFY(isNear(raised.sharePercent(raised.lines.back()), 64.0));
    }

    void fewReadings_factorAndUMeetTheLeast_data()
    {
        QTest::addColumn<double>("dof");
        QTest::addColumn<double>("least");
        for (const double dof : {1.0, 2.0, 3.0, 9.0, 1e3})
            for (const double least : {2.0, 30.0, 300.0})
                QTest::addRow("%g %g", dof, least) << dof << least;
    }
    void fewReadings_factorAndUMeetTheLeast()
    {
        QFETCH(double, dof);
        QFETCH(double, least);
        const double before = *value(0.3, dof, 0.0).expanded();
        const ReportedValue raised = value(0.3, dof, least);
        QVERIFY(isNear(*raised.expanded(), std::max(before, least), 1e-9));
        QCOMPARE(raised.lines.size(), before < least ? 2U : 1U);
        ReportedValue again = raised; // the same line, not a second one
        combineLines(again);
        QCOMPARE(again.lines.size(), raised.lines.size());
        QVERIFY(isNear(*again.u, *raised.u));
    }

    void leastIsTheLargestThatApplies()
    {
        QCOMPARE(leastExpanded(kAll, "magnitude", -2.0, 5e3), 0.1);
        QCOMPARE(leastExpanded(kAll, "magnitude", 2.0, 2e4), 0.08);
        QCOMPARE(leastExpanded(kAll, "phase_rad", 3.0, 2e4), 0.05);
        QCOMPARE(leastExpanded(kAll, "q", 3.0), 0.0);
    }

    void entry_countsBetweenItsEnds()
    {
        const std::vector<CapabilityEntry> band{relative("magnitude", 0.1, 1e3, 1e4)};
        for (const double f_Hz : {1e3, 3e3, 1e4})
            QCOMPARE(leastExpanded(band, "magnitude", 1.0, f_Hz), 0.1);
        for (const double f_Hz : {999.0, 10001.0})
            QCOMPARE(leastExpanded(band, "magnitude", 1.0, f_Hz), 0.0);
        const std::vector<CapabilityEntry> absolute{{"f0_hz", 5.0, false}};
        QCOMPARE(leastExpanded(absolute, "f0_hz", 1e6), 5.0);
    }

    void scope_isWhereSomeEntryOfRowsHolds()
    {
        const std::vector<CapabilityEntry> band{
            relative("magnitude", 0.1, 1e3, 1e4), relative("magnitude", 0.2, 2e4)};
        for (const double f_Hz : {1e3, 1e4, 2e4, 1e9})
            QVERIFY(!isOutsideScope(band, f_Hz));
        for (const double f_Hz : {999.0, 1.5e4})
            QVERIFY(isOutsideScope(band, f_Hz));
        QVERIFY(!isOutsideScope({}, 1e3)); // who states no range is held to none
        QVERIFY(
            !isOutsideScope({relative("sensitivity", 0.1), {"phase_rad", 0.1, true, 1e3}}, 1.0));
    }

    void valuesOutsideTheScope_areACaution()
    {
        const auto findingsWith = [&](const std::vector<CapabilityEntry> &cmc) {
            UncertaintyReport report = *m_results.uncertainty;
            report.findings.clear();
            holdToCapability(cmc, *m_results.response, report);
            return report.findings;
        };
        QVERIFY(findingsWith({relative("magnitude", 0.1)}).empty());
        QVERIFY(findingsWith({relative("sensitivity", 0.1)}).empty());
        const Findings found = findingsWith({relative("magnitude", 0.1, 0.0, 1e4)});
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().id, std::string("CER-007"));
        QVERIFY(found.front().severity == Severity::Caution);
        Index above = 0; // counted here, apart from the program
        const ResponseResult &response = *m_results.response;
        for (Index i = 0; i < response.frequency_Hz.size(); ++i)
            above += response.frequency_Hz[i] > 1e4 && std::isfinite(response.magnitude[i])
                && std::isfinite(m_results.uncertainty->rows.u_magnitude[i]);
        const ResponseResult &marked = *response.atMarks;
        for (Index i = 0; i < marked.frequency_Hz.size(); ++i)
            above += marked.frequency_Hz[i] > 1e4 && std::isfinite(marked.magnitude[i])
                && std::isfinite(m_results.uncertainty->rowsAtMarks.u_magnitude[i]);
        QVERIFY(above > 3);
        QCOMPARE(found.front().message.arguments.front(), std::to_string(above));
    }

    void nothingOfACalibration_isBelow()
    {
        Index held = 0;
        for (const Budget &budget : allBudgets(*m_results.uncertainty, *m_results.response)) {
            if (!budget.reported.u)
                continue;
            const bool isPhase = budget.kind == BudgetOf::Phase;
            const double least = isPhase
                ? leastExpanded(kAll, "phase_rad", 1.0, budget.frequency_Hz) * 360.0 / kTwoPi
                : leastExpanded(
                    kAll, budget.reported.of, budget.reported.value, budget.frequency_Hz);
            QVERIFY(*budget.reported.expanded() >= least * (1.0 - 1e-12));
            held += least > 0.0 && isNear(*budget.reported.expanded(), least, 1e-9) ? 1 : 0;
        }
        QVERIFY(held > 10);
        QVERIFY(uOfSensitivity(m_results.uncertainty.get()) >= 0.5
                * leastExpanded(kAll, "sensitivity", *m_results.response->sensitivity)
                * (1.0 - 1e-12));
        const UncertaintyReport *report = m_results.uncertainty.get();
        for (std::size_t i = 0; i < m_results.response->shots.size(); ++i)
            QVERIFY(isNear(kOfShot(report, i) * uOfShot(report, i),
                0.03 * *m_results.response->shots[i].sensitivity, 1e-9));
    }

    /// What made most of u is not in the way once the CMC acts.
    void dominantLine_isNotTold_whereTheCapabilityActs()
    {
        UncertaintyReport report = *m_results.uncertainty;
        report.findings = {{.id = "UNC-001"}, {.id = "UNC-002"}};
        UncertaintyReport other = report;
        holdToCapability(kAll, *m_results.response, report);
        QCOMPARE(report.findings.size(), 1);
        holdToCapability({relative("sensitivity", 1e-9)}, *m_results.response, other);
        QCOMPARE(other.findings.size(), 2);
    }

    /// Q = 1/(2 damping) has the same relative U: neither is stated better than the other.
    void dampingAndQ_holdEachOther()
    {
        UncertaintyReport report;
        for (const auto &[of, size] : {std::pair("damping_ratio", 0.05), std::pair("q", 10.0)}) {
            report.ofModel.push_back({of, size, "", {directLine("noise", 1e-4 * size)}});
            combineLines(report.ofModel.back());
        }
        for (const auto &entry :
            {relative("damping_ratio", 0.02), relative("q", 0.02),
                CapabilityEntry{"damping_ratio", 0.001, false}, CapabilityEntry{"q", 0.2, false}}) {
            UncertaintyReport held = report;
            holdToCapability({entry}, ResponseResult(), held);
            for (const ReportedValue &one : held.ofModel)
                QVERIFY2(isNear(*one.expanded(), 0.02 * one.value), one.of.c_str());
        }
    }

    void absoluteOne_holdsTheModelToo()
    {
        UncertaintyReport report = *m_results.uncertainty;
        holdToCapability({{"magnitude", 1e-6, false}}, *m_results.response, report);
        QVERIFY(report.rows.u_modelMagnitude.minCoeff() >= 0.5e-6 * (1.0 - 1e-12));
    }

    /// Rows and their budgets say the same; the row's own covariance has no part of it.
    void rows_areTheirBudgets()
    {
        const RowUncertainty &rows = m_results.uncertainty->rows;
        const ResponseResult &response = *m_results.response;
        for (Index row = 0; row < rows.u_magnitude.size(); ++row) {
            if (!std::isfinite(rows.u_magnitude[row]))
                continue;
            QVERIFY(isNear(*magnitudeOfRow(response, rows, row).u, rows.u_magnitude[row]));
            QVERIFY(rows.u_modelMagnitude[row] >= 0.02 * response.modelMagnitude[row] - 1e-20);
            QVERIFY(rows.u_modelPhase_rad[row] >= 0.025);
        }
        UncertaintyReport report = *m_results.uncertainty;
        const UncertaintyReport before = report;
        holdToCapability({}, response, report);
        QVERIFY(report.rows.u_magnitude == before.rows.u_magnitude);
    }
};

DYNCAL_TEST(TestCapability)
#include "tst_capability.moc"
