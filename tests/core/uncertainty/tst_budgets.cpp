// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// All values of a calibration with their budgets, as the report has them.

#include "core/pipeline/pipeline.h"
#include "core/uncertainty/budgets.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace dyncal;

class TestBudgets : public QObject
{
    Q_OBJECT

private:
    CalibrationResults m_results;

    std::vector<Budget> all() const
    {
        return allBudgets(*m_results.uncertainty, *m_results.response);
    }
    static Index count(const std::vector<Budget> &budgets, BudgetOf kind)
    {
        return static_cast<Index>(std::ranges::count(budgets, kind, &Budget::kind));
    }

private slots:
    void initTestCase()
    {
        ResultCache cache;
        m_results
            = runPipeline(testing::simulatedExample(2e7), {}, cache, StageId::Uncertainty).results;
    }

    void everyValue_isThere()
    {
        const std::vector<Budget> budgets = all();
        QCOMPARE(count(budgets, BudgetOf::Sensitivity), Index(1));
        QCOMPARE(count(budgets, BudgetOf::Level), Index(3));
        QCOMPARE(count(budgets, BudgetOf::Model), std::ssize(m_results.uncertainty->ofModel));
        QVERIFY(count(budgets, BudgetOf::Magnitude) > 10);
        QCOMPARE(count(budgets, BudgetOf::Magnitude), count(budgets, BudgetOf::Phase));
        QVERIFY(std::ranges::is_sorted(budgets, {}, &Budget::kind));
    }

    void shots_areThoseOfTheValue()
    {
        for (const Budget &budget : all())
            QCOMPARE(budget.shots, budget.kind == BudgetOf::Level ? Index(1) : Index(3));
    }

    /// What the tables of the report say without lines, the lines make.
    void rows_haveTheUOfTheReport()
    {
        const auto &rows = m_results.uncertainty->rows;
        const Eigen::VectorXd &frequency_Hz = m_results.response->frequency_Hz;
        for (const Budget &budget : all()) {
            if (budget.kind != BudgetOf::Magnitude && budget.kind != BudgetOf::Phase)
                continue;
            const auto row
                = std::ranges::find(frequency_Hz, budget.frequency_Hz) - frequency_Hz.begin();
            const bool isPhase = budget.kind == BudgetOf::Phase;
            const double u = isPhase ? 180.0 / std::numbers::pi * rows.u_phase_rad[row]
                                     : rows.u_magnitude[row];
            QVERIFY(std::abs(*budget.reported.u / u - 1.0) < 1e-12);
            const double k = (isPhase ? rows.k_phase : rows.k_magnitude)[row];
            QVERIFY(std::abs(budget.reported.k / k - 1.0) < 1e-9);
            QCOMPARE(budget.reported.unit, std::string(isPhase ? "\xC2\xB0" : "V/Pa"));
        }
    }

    void unknownStep_leavesMagnitudesWithoutU()
    {
        UncertaintyReport report = *m_results.uncertainty;
        report.rows.u_magnitude.setConstant(kUnknown);
        for (const Budget &budget : allBudgets(report, *m_results.response))
            if (budget.kind == BudgetOf::Magnitude)
                QVERIFY(!budget.reported.u && *budget.reported.missing.text != '\0');
        report.sensitivity.reset();
        QCOMPARE(count(allBudgets(report, *m_results.response), BudgetOf::Sensitivity), Index(0));
    }

    void withheldRows_areLeftOut()
    {
        ResponseResult response = *m_results.response;
        const Index before = count(all(), BudgetOf::Phase);
        response.magnitude[response.magnitude.size() / 2] = kUnknown;
        QCOMPARE(count(allBudgets(*m_results.uncertainty, response), BudgetOf::Phase), before - 1);
        response.magnitude.resize(0);
        QCOMPARE(count(allBudgets(*m_results.uncertainty, response), BudgetOf::Phase), Index(0));
    }
};

DYNCAL_TEST(TestBudgets)
#include "tst_budgets.moc"
