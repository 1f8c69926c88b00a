// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Another u of an input, and what it does to every value; closed forms.

#include "core/pipeline/pipeline.h"
#include "core/uncertainty/what_if.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

bool isClose(double found, double expected)
{
    return std::abs(found - expected) <= 1e-12 * std::abs(expected);
}

UncertaintyLine inputLine(const char *quantity, double u, double sensitivity)
{
    UncertaintyLine line = directLine(quantity, u);
    line.sensitivity = sensitivity;
    line.contribution = sensitivity * u;
    return line;
}

/// 3 from T1, 4 from the noise, of 100: u = 5.
ReportedValue threeAndFour()
{
    ReportedValue reported{
        "sensitivity", 100.0, "V/Pa", {inputLine("t1_k", 0.3, -10.0), directLine("noise", 4.0, 8)}};
    combineLines(reported);
    return reported;
}

} // namespace

class TestWhatIf : public QObject
{
    Q_OBJECT

private slots:
    void nothingChanged_isTheSame()
    {
        const ReportedValue same = withChanges(threeAndFour(), {});
        QCOMPARE(*same.u, 5.0);
        QCOMPARE(*withChanges(threeAndFour(), {{"gamma", 1.0, 2.0}}).u, 5.0);
    }

    void anotherU_entersWithItsSensitivity()
    {
        const ReportedValue changed = withChanges(threeAndFour(), {{"t1_k", 0.3, 1.2}});
        QCOMPARE(changed.lines[0].u, 1.2);
        QCOMPARE(changed.lines[0].contribution, -12.0);
        QVERIFY(isClose(*changed.u, std::hypot(12.0, 4.0)));
        // Welch-Satterthwaite: the noise alone has finite degrees of freedom.
        QVERIFY(isClose(changed.dof, 8.0 * std::pow(*changed.u / 4.0, 4)));
        QVERIFY(isClose(changed.k, coverageFactor(changed.dof, 0.95)));
        QVERIFY(isClose(*changed.expanded(), std::max(2.0, changed.k) * *changed.u));
    }

    void severalAtOnce_andZero()
    {
        const ReportedValue changed
            = withChanges(threeAndFour(), {{"t1_k", 0.3, 0.0}, {"noise", 4.0, 1.0}});
        QVERIFY(isClose(*changed.u, 1.0));
        QVERIFY(isClose(changed.dof, 8.0));
    }

    /// A shot that knows the input half as well, and a value that is a hundred times as large.
    void linesOfOneName_changeInProportion()
    {
        ReportedValue reported{"x", 1.0, "",
            {inputLine("arrival_s[A]", 2e-6, 1.0), inputLine("arrival_s[A]", 4e-6, 1.0)}};
        combineLines(reported);
        const ReportedValue changed = withChanges(reported, {{"arrival_s[A]", 2e-6, 3e-6}});
        QVERIFY(isClose(changed.lines[0].u, 3e-6));
        QVERIFY(isClose(changed.lines[1].u, 6e-6));
    }

    void zeroBefore_takesTheNewOne()
    {
        ReportedValue reported{"x", 1.0, "", {inputLine("clock_relative", 0.0, 2e6)}};
        combineLines(reported);
        QVERIFY(isClose(*withChanges(reported, {{"clock_relative", 0.0, 1e-6}}).u, 2.0));
    }

    void withoutU_staysWithout()
    {
        ReportedValue reported = threeAndFour();
        reported.u.reset();
        QVERIFY(!withChanges(reported, {{"t1_k", 0.3, 1.2}}).u);
    }

    void budget_takesWhatItCanState()
    {
        QCOMPARE(budgetKeyOf(directLine("t1_k", 0.3), {}), std::string("t1_k"));
        QCOMPARE(budgetKeyOf(directLine("clock_relative", 0.3), {}), std::string("clock_relative"));
        for (const char *computed : {"noise", "attenuation_per_m", "distance_m[Side 1]",
                 "front_unknown", "scatter_of_shots"})
            QVERIFY2(budgetKeyOf(directLine(computed, 0.3), {}).empty(), computed);
    }

    /// One entry of the budget for all places: what knows it otherwise is not meant.
    void statedForAllPlaces_changesThemTogether()
    {
        const std::vector<BudgetEntry> budget{{"arrival_s", 1e-6, "normal", {}}};
        QCOMPARE(budgetKeyOf(directLine("arrival_s[A]", 1e-6), budget), std::string("arrival_s"));
        QCOMPARE(
            budgetKeyOf(directLine("time_s[counter 1]", 1e-6), budget), std::string("arrival_s"));
        QVERIFY(budgetKeyOf(directLine("arrival_s[B]", 2e-9), budget).empty());
        QVERIFY(budgetKeyOf(directLine("delay_s[A]", 1e-6), budget).empty());
        ReportedValue reported{"x", 1.0, "",
            {inputLine("arrival_s[A]", 1e-6, 1.0), inputLine("arrival_s[B]", 1e-6, 2.0),
                inputLine("arrival_s[C]", 2e-9, 1.0)}};
        combineLines(reported);
        const ReportedValue changed = withChanges(reported, {{"arrival_s", 1e-6, 3e-6}});
        QVERIFY(isClose(changed.lines[0].contribution, 3e-6));
        QVERIFY(isClose(changed.lines[1].contribution, 6e-6));
        QCOMPARE(changed.lines[2].u, 2e-9);
    }

    void budget_replacesOrAppends()
    {
        const UncertaintyLine gain
            = directLine("gain_relative", 0.003, 12.0, Distribution::Rectangular);
        const std::vector<BudgetEntry> before{{"t1_k", 0.3, "normal", {}}};
        const auto appended = withStated(before, "gain_relative", gain, 0.001);
        QCOMPARE(appended.size(), std::size_t(2));
        QVERIFY((appended[1] == BudgetEntry{"gain_relative", 0.001, "rectangular", 12.0}));
        const auto replaced = withStated(appended, "t1_k", directLine("t1_k", 0.3), 0.1);
        QCOMPARE(replaced.size(), std::size_t(2));
        QVERIFY((replaced[0] == BudgetEntry{"t1_k", 0.1, "normal", {}}));
        QVERIFY(withStated(before, "", directLine("noise", 1.0), 0.1) == before);
    }

    /// Another u is of the same reference: the certificate stays traceable.
    void statedAnew_keepsItsReference()
    {
        const std::vector<BudgetEntry> before{{"t1_k", 0.3, "normal", {}, "R-1", "2027-01-31"}};
        const auto after = withStated(before, "t1_k", directLine("t1_k", 0.3), 0.1);
        QVERIFY((after[0] == BudgetEntry{"t1_k", 0.1, "normal", {}, "R-1", "2027-01-31"}));
    }

    /// What was tried is what a run gives once the recipe states it, value by value.
    void tried_isWhatTheRecipeGives()
    {
        const auto set = testing::simulatedExample(2e7);
        ResultCache cache;
        const auto run = [&](const Recipe &recipe) {
            return runPipeline(set, recipe, cache, StageId::Uncertainty).results.uncertainty;
        };
        const auto before = run({});
        Recipe recipe;
        std::vector<ChangedU> changes;
        for (const char *quantity : {"t1_k", "gain_relative", "p1_pa"}) {
            const auto &lines = before->sensitivity->lines;
            const auto line = std::ranges::find(lines, quantity, &UncertaintyLine::quantity);
            QVERIFY2(line != lines.end(), quantity);
            changes.push_back({quantity, line->u, 3.0 * line->u});
            recipe.uncertainty.budget
                = withStated(recipe.uncertainty.budget, quantity, *line, changes.back().to);
        }
        const auto after = run(recipe);
        const auto agree = [&](const ReportedValue &tried, const ReportedValue &stated) {
            return std::abs(*withChanges(tried, changes).u / *stated.u - 1.0) < 1e-3;
        };
        QVERIFY(*after->sensitivity->u > 1.1 * *before->sensitivity->u);
        QVERIFY(agree(*before->sensitivity, *after->sensitivity));
        for (std::size_t i = 0; i < before->perLevel.size(); ++i)
            QVERIFY(agree(before->perLevel[i], after->perLevel[i]));
    }
};

DYNCAL_TEST(TestWhatIf)
#include "tst_what_if.moc"
