// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page of the budget says of the Monte Carlo.

#include "tests/support/made_monte_carlo.h"
#include "tests/support/test_program.h"
#include "ui/stages/uncertainty/budget_table.h"
#include "ui/stages/uncertainty/drawn_words.h"

#include <QTest>

using namespace dyncal;

namespace {

Budget budget(BudgetOf kind, const char *of, double value, const char *unit, double f_Hz = kUnknown)
{
    Budget made;
    made.kind = kind;
    made.frequency_Hz = f_Hz;
    made.reported = {of, value, unit, {directLine("noise", 0.01 * std::abs(value))}};
    combineLines(made.reported);
    return made;
}

std::vector<Budget> budgets()
{
    return {budget(BudgetOf::Sensitivity, "sensitivity", 5e-6, "V/Pa"),
        budget(BudgetOf::Level, "sensitivity", 5.1e-6, "V/Pa"),
        budget(BudgetOf::Model, "f0_hz", 1e5, "Hz"),
        budget(BudgetOf::Model, "within_5_percent_hz", 2e4, "Hz"),
        budget(BudgetOf::Model, "settling_time_s", 1e-5, "s"),
        budget(BudgetOf::Model, "q", 5.0, ""),
        budget(BudgetOf::Magnitude, "magnitude", 5e-6, "V/Pa", 1e3),
        budget(BudgetOf::Phase, "phase", -5.73, "°", 1e3),
        budget(BudgetOf::Magnitude, "magnitude", 5e-6, "V/Pa", 1e5)};
}

} // namespace

class TestDrawnWords : public QObject
{
    Q_OBJECT

private slots:
    void everyBudget_findsItsOwn()
    {
        const ChainMonteCarlo drawn = testing::madeMonteCarlo();
        const auto list = drawnOf(budgets(), &drawn);
        QCOMPARE(std::ssize(list), Index(9));
        QCOMPARE(list[0].drawn, &drawn.values[0].drawn);
        QCOMPARE(list[1].drawn, &drawn.values[1].drawn);
        QCOMPARE(list[3].drawn, &drawn.values[3].drawn);
        QVERIFY(!list[5].drawn); // not drawn
        QCOMPARE(list[6].drawn, &drawn.rows[0].magnitude);
        QCOMPARE(list[7].drawn, &drawn.rows[0].phase);
        QVERIFY(!list[8].drawn); // withheld
    }

    void withoutAMonteCarlo_thereIsNone()
    {
        const auto list = drawnOf(budgets(), nullptr);
        QCOMPARE(std::ssize(list), Index(9));
        QCOMPARE(drawnCell(list[0], budgets()[0]), QStringLiteral("–"));
        QCOMPARE(drawnSentence(list[0], budgets()[0]),
            QStringLiteral("Monte Carlo: none of this value yet."));
    }

    void cells_sayValidatedOrTheOtherU()
    {
        const ChainMonteCarlo drawn = testing::madeMonteCarlo();
        const auto all = budgets();
        const auto list = drawnOf(all, &drawn);
        QCOMPARE(drawnCell(list[2], all[2]), QStringLiteral("validated"));
        QCOMPARE(drawnCell(list[3], all[3]), QStringLiteral("U = 2.9 %"));
        QCOMPARE(drawnCell(list[4], all[4]), QStringLiteral("–"));
        QCOMPARE(drawnCell(list[7], all[7]), QStringLiteral("U = 0.57 °")); // 0.01 rad
        const ShownTable table = allValues(all, {}, list);
        QCOMPARE(table.headers.back(), QStringLiteral("Monte Carlo"));
        QCOMPARE(table.rows[3].back(), QStringLiteral("U = 2.9 %"));
        QCOMPARE(table.rows[5].back(), QStringLiteral("–"));
    }

    void sentences_haveBothU()
    {
        const ChainMonteCarlo drawn = testing::madeMonteCarlo();
        const auto all = budgets();
        const auto list = drawnOf(all, &drawn);
        QCOMPARE(drawnSentence(list[3], all[3]),
            QStringLiteral(
                "Monte Carlo, 10000 trials: from 19.42 kHz to 20.58 kHz, U = 2.9 %. It does not validate the law of propagation (U = 2.4 %)."));
        QVERIFY(drawnSentence(list[2], all[2])
                    .contains("It validates the law of propagation (U = 0.2"));
        QCOMPARE(drawnSentence(list[4], all[4]),
            QStringLiteral("Monte Carlo, 10000 trials: in 3 of them the value does not exist."));
    }
};

DYNCAL_TEST(TestDrawnWords)
#include "tst_drawn_words.moc"
