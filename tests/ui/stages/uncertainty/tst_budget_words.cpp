// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Budgets in words, from budgets written down.

#include "tests/support/test_program.h"
#include "ui/stages/uncertainty/budget_sentences.h"
#include "ui/stages/uncertainty/budget_table.h"
#include "ui/stages/uncertainty/budget_words.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

UncertaintyLine relativeLine(const char *quantity, double u, double value)
{
    return scaled({directLine(quantity, u)}, value).front();
}

/// S = 5 µV/Pa; u of 0.4 % (gain) and 0.3 % (noise of three shots).
Budget sensitivityBudget()
{
    const double S = 5e-6;
    Budget budget{BudgetOf::Sensitivity, ShotLevel::None, kUnknown, 3, {"sensitivity", S, "V/Pa"}};
    budget.reported.lines = {relativeLine("gain_relative", 0.004, S)};
    for (Index shot = 1; shot <= 3; ++shot) {
        budget.reported.lines.push_back(
            with(OverShots::Own, relativeLine("level_relative", 0.003 / std::sqrt(3.0), S)));
        budget.reported.lines.back().shot = shot;
    }
    combineLines(budget.reported);
    return budget;
}

} // namespace

class TestBudgetWords : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void names_sayWhatItIsOf()
    {
        Budget budget = sensitivityBudget();
        QCOMPARE(budgetName(budget), QString("Sensitivity"));
        budget.kind = BudgetOf::Level;
        budget.level = ShotLevel::High;
        QCOMPARE(budgetName(budget), QString("Sensitivity, level High"));
        budget.kind = BudgetOf::Model;
        budget.reported.of = "damping_ratio";
        QCOMPARE(budgetName(budget), QString("Damping ratio ζ"));
        budget.reported.of = "new & unknown";
        QCOMPARE(budgetName(budget), QString("new & unknown"));
        budget.kind = BudgetOf::Magnitude;
        budget.frequency_Hz = 1e5;
        QCOMPARE(budgetName(budget), QString("Magnitude of S(f) at 100 kHz"));
        budget.kind = BudgetOf::Phase;
        QCOMPARE(quantityName(budget), QString("Phase of S(f)"));
    }

    void lines_haveTheirUnits()
    {
        const ReportedValue S{"sensitivity", 5e-6, "V/Pa"};
        const ReportedValue phase{"phase", -20.0, "\xC2\xB0"};
        QCOMPARE(uText(0.3, directLine("t1_k", 0.3), S), QString("0.30 K"));
        QCOMPARE(uText(2e-4, directLine("distance_m[A]", 2e-4), S), QString("200 µm"));
        QCOMPARE(uText(0.0005, directLine("gamma", 0.0005), S), QString("0.00050"));
        QCOMPARE(uText(0.004, relativeLine("gain_relative", 0.004, 5e-6), S), QString("0.40 %"));
        QCOMPARE(uText(1e-8, directLine("noise", 1e-8), S), QString("0.20 %")); // of the value
        QCOMPARE(uText(0.5, directLine("noise", 0.5), phase), QString("0.50 °"));
        QCOMPARE(uText(0.01, relativeLine("front_unknown", 0.01, 5e-6), S), QString("1.0 %"));
        QCOMPARE(lineName(directLine("arrival_s[Side 1]", 1.0)), QString("Arrival, Side 1"));
        UncertaintyLine ofShot = directLine("level_relative", 1.0);
        ofShot.shot = 2;
        QCOMPARE(lineName(ofShot), QString("Noise of the level, shot 2"));
    }

    void result_isWrittenAsMetrologistsDo()
    {
        Budget budget = sensitivityBudget();
        QCOMPARE(resultSentence(budget),
            QString("Sensitivity = 5.000 µV/Pa, U = 0.050 µV/Pa (k = 2), 1.0 % of it"));
        budget.reported.u.reset();
        budget.reported.missing = {"that of the step is not known", {}};
        QCOMPARE(resultSentence(budget),
            QString(
                "Sensitivity = 5.00 µV/Pa; its uncertainty is not complete: that of the step is not known."));
    }

    void wanted_isSaid()
    {
        const Budget budget = sensitivityBudget();
        const auto said = [&](double relative) {
            const WantedU wanted{relative, 2.0};
            return wantedSentence(budget, wanted, wayToU(budget.reported, wanted));
        };
        QCOMPARE(said(0.02), QString("U of 2 % is reached."));
        // sqrt(0.35^2 - 0.3^2) = 0.18 %
        QCOMPARE(said(0.007),
            QString("For U of 0.7 % one of these is enough: Gain of the chain, u ≤ 0.18 %."));
        QCOMPARE(said(0.004),
            QString(
                "For U of 0.4 % no input alone is enough. Known exactly, these together are: Gain of the chain; Noise of the level."));
        QCOMPARE(wantedSentence(budget, {}, std::nullopt),
            QString("No relative U can be asked of this value."));
    }

    void shots_areSaid()
    {
        // 2 sqrt(0.16 + 0.27 / n) %
        QCOMPARE(shotsSentence(sensitivityBudget()),
            QString(
                "U by the number of shots: 1: 1.3 %, 3: 1.0 %, 6: 0.91 %, 12: 0.85 %, 20: 0.83 %; never below 0.80 %."));
        Budget shared = sensitivityBudget();
        shared.reported.lines.resize(1);
        combineLines(shared.reported);
        QCOMPARE(shotsSentence(shared),
            QString("More shots do not make it smaller: U is 0.80 %, never below 0.80 %."));
        Budget unknown = sensitivityBudget();
        unknown.reported.u.reset();
        QVERIFY(shotsSentence(unknown).isEmpty());
        QVERIFY(shotsTable(unknown).rows.isEmpty());
        Budget scatter = sensitivityBudget();
        scatter.reported.lines
            = {with(OverShots::Scatter, directLine("scatter_of_shots", 5e-8, 2))};
        combineLines(scatter.reported);
        QVERIFY(shotsSentence(scatter).contains("1: not known, 3: 4.3 %"));
        QCOMPARE(shotsTable(scatter).rows[0][1], QString("–"));
    }

    void rows_areSorted_andSayWhatIsTried()
    {
        Budget budget = sensitivityBudget();
        TriedChanges tried;
        tried.set(budget.reported.lines[1], 0.03, {});
        const Budget changed = tried.appliedTo({budget}).front();
        const ShownTable table
            = budgetLines(changed, tried, wayToU(changed.reported, {0.015, 2.0}));
        QCOMPARE(table.rows.size(), 4);
        QCOMPARE(table.rows[0][0], QString("Noise of the level, shot 1 (what if)"));
        QCOMPARE(table.rows[3][0], QString("Gain of the chain"));
        QCOMPARE(table.rows[3][8], QString("not enough alone"));
        QVERIFY(table.rows[0][8].startsWith("≤ "));
        for (const QStringList &row : table.rows)
            QCOMPARE(row.size(), table.headers.size());
        QCOMPARE(allValues({budget}, {changed}).rows[0][2], QString("1.0 %"));
        QVERIFY(allValues({budget}, {changed}).rows[0][3] != "1.0 %");
    }

    void trials_areForgottenWithTheirLine()
    {
        const Budget budget = sensitivityBudget();
        TriedChanges tried;
        tried.set(budget.reported.lines[0], 0.001, {});
        tried.set(budget.reported.lines[1], 0.001, {});
        QVERIFY(tried.has(budget.reported.lines[0]) && tried.has(budget.reported.lines[1]));
        QCOMPARE(tried.notStatable(), std::vector<std::string>{"level_relative"});
        QCOMPARE(tried.stated({}).size(), std::size_t(1));
        tried.keepThoseOf({budget});
        QCOMPARE(tried.changes().size(), std::size_t(2));
        Budget other = budget;
        other.reported.lines[0].u = 0.001; // taken over
        tried.keepThoseOf({other});
        QVERIFY(!tried.has(budget.reported.lines[0]) && tried.has(budget.reported.lines[1]));
        tried.set(budget.reported.lines[1], budget.reported.lines[1].u, {});
        QVERIFY(tried.isEmpty());
    }

    /// What the budget states for all places is tried, and stated, for all at once.
    void trials_ofAllPlaces_goTogether()
    {
        Budget budget = sensitivityBudget();
        budget.reported.lines
            = {directLine("arrival_s[A]", 1e-9), directLine("arrival_s[B]", 1e-9)};
        combineLines(budget.reported);
        TriedChanges tried;
        tried.set(budget.reported.lines[0], 3e-9, {{"arrival_s", 1e-9, "normal", {}}});
        const Budget changed = tried.appliedTo({budget}).front();
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(tried.has(budget.reported.lines[i]) && tried.has(changed.reported.lines[i]));
            QVERIFY(std::abs(changed.reported.lines[i].u - 3e-9) < 1e-18);
        }
        QVERIFY(tried.notStatable().empty());
        QCOMPARE(tried.stated({{"arrival_s", 1e-9, "normal", {}}}).front().u, 3e-9);
        tried.set(budget.reported.lines[1], 2e-9, {{"arrival_s", 1e-9, "normal", {}}});
        QCOMPARE(tried.changes().size(), std::size_t(1));
    }
};

DYNCAL_TEST(TestBudgetWords)
#include "tst_budget_words.moc"
