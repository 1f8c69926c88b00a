// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The page of the budget, driven by its controls, over the example's real results.

#include "core/uncertainty/more_shots.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/uncertainty/budget_table.h"
#include "ui/stages/uncertainty/share_bar.h"
#include "ui/stages/uncertainty/uncertainty_page.h"

#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QtTest>

using namespace dyncal;
using Bench = test::PageBench<test::ScriptedPage<UncertaintyPage>>;

namespace {

constexpr int kInput = 0;
constexpr int kU = 2;
constexpr int kNeeded = 8;

int rowOf(const ValueTable &table, const QString &begin)
{
    for (int row = 0; row < table.rowCount(); ++row)
        if (table.item(row, kInput)->text().startsWith(begin))
            return row;
    return -1;
}

QString cell(const ValueTable &table, const QString &begin, int column)
{
    const int row = rowOf(table, begin);
    return row < 0 ? QString() : table.item(row, column)->text();
}

void chooseText(Bench &bench, const QString &box, const QString &text)
{
    const int at = bench.control<QComboBox>(box)->findText(text);
    QVERIFY2(at >= 0, qPrintable(text));
    bench.choose(box, at);
}

} // namespace

class TestUncertaintyPage : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench;

    ValueTable &table(const char *name) const { return *m_bench->control<ValueTable>(name); }
    QString label(const char *name) const { return m_bench->control<QLabel>(name)->text(); }
    bool has(const char *name, const QString &words) const { return label(name).contains(words); }
    void tryU(const QString &input, const QString &u) const
    {
        chooseText(*m_bench, "whatIfInput", input);
        m_bench->type("whatIfUValue", u);
    }
    void press(const char *name) const { m_bench->control<QPushButton>(name)->click(); }
    bool isEnabled(const char *name) const
    {
        return m_bench->control<QPushButton>(name)->isEnabled();
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
        QTRY_VERIFY_WITH_TIMEOUT(
            m_bench->session.results().uncertainty && table("budgetTable").rowCount() > 5, 30000);
    }
    void cleanup() { m_bench.reset(); }

    void budget_isSorted_withBars();
    void everyQuantity_isOffered();
    void trial_changesEveryU_notTheRecipe();
    void trial_isTakenOver_asOneStep();
    void trial_ofWhatNoBudgetStates();
    void trial_isRefused_orTakenBack();
    void row_choosesItsInput();
    void wantedU_saysWhatIsInTheWay();
    void shots_areTold();
    void unknownStep_isSaid();
    void swedish_hasNoEnglishNumbers();
};

void TestUncertaintyPage::budget_isSorted_withBars()
{
    const ValueTable &lines = table("budgetTable");
    double before = 2.0;
    double sum = 0.0;
    for (int row = 0; row < lines.rowCount(); ++row) {
        const double share = lines.item(row, kShareColumn)->data(ShareBar::kShareRole).toDouble();
        QVERIFY(share <= before);
        before = share;
        sum += share;
    }
    QVERIFY(std::abs(sum - 1.0) < 1e-9);
    QCOMPARE(cell(lines, "T1", 1), QString("294.15 K"));
    QCOMPARE(cell(lines, "T1", kU), QString("0.30 K"));
    QCOMPARE(cell(lines, "Gain", kU), QString("0.29 %"));
    QCOMPARE(cell(lines, "Gain", 5), QString("rectangular"));
    QCOMPARE(cell(lines, "Gain", 6), QString("∞"));
    QVERIFY(cell(lines, "T1", 7).endsWith("V/Pa per K"));
    QVERIFY2(has("uncertaintyResult", "Sensitivity = 5.0"), qPrintable(label("uncertaintyResult")));
    QVERIFY(has("uncertaintyResult", "(k = 2)"));
    QVERIFY(!m_bench->page.plots().front()->content().curves.empty());
    QVERIFY(!m_bench->page.grab().isNull()); // the bars are painted
}

void TestUncertaintyPage::everyQuantity_isOffered()
{
    auto *box = m_bench->control<QComboBox>("uncertaintyQuantity");
    auto *frequency = m_bench->control<QComboBox>("uncertaintyFrequency");
    QVERIFY(!frequency->isEnabled());
    QVERIFY(frequency->count() > 10);
    for (int i = 0; i < box->count(); ++i) {
        m_bench->choose("uncertaintyQuantity", i);
        QVERIFY2(label("uncertaintyResult").startsWith(box->itemText(i)),
            qPrintable(label("uncertaintyResult")));
        QVERIFY(table("budgetTable").rowCount() >= 1); // of the damping: the noise alone
        QTRY_VERIFY2(box->height() >= box->heightForWidth(box->width()),
            qPrintable(box->itemText(i))); // a name of two lines has room for both
    }
    QVERIFY(frequency->isEnabled()); // the phase is last
    m_bench->choose("uncertaintyFrequency", 4);
    QVERIFY(has("uncertaintyResult", "at " + frequency->currentText()));
    QVERIFY(has("uncertaintyResult", "°"));
    QVERIFY(has("wantedNote", "No relative U"));
    const auto budgets
        = allBudgets(*m_bench->session.results().uncertainty, *m_bench->session.results().response);
    QCOMPARE(table("allUncertainties").rowCount(), static_cast<int>(budgets.size()));
}

void TestUncertaintyPage::trial_changesEveryU_notTheRecipe()
{
    const ValueTable &all = table("allUncertainties");
    const Recipe before = m_bench->recipe();
    QCOMPARE(cell(all, "Sensitivity", 3), QString("–"));
    QVERIFY(!isEnabled("whatIfReset"));
    tryU("Gain of the chain", "5 %");
    QVERIFY(m_bench->recipe() == before);
    QVERIFY(m_bench->control<QLabel>("whatIfResult")->isVisible());
    QVERIFY2(has("whatIfResult", "10 % of it"), qPrintable(label("whatIfResult")));
    QCOMPARE(cell(all, "Sensitivity", 3), QString("10 %"));
    QVERIFY(cell(all, "Magnitude of S(f)", 3).startsWith("10"));
    QVERIFY(cell(all, "Sensitivity", 2) != cell(all, "Sensitivity", 3));
    QCOMPARE(cell(all, "Natural", 2), cell(all, "Natural", 3)); // has no gain
    QCOMPARE(rowOf(table("budgetTable"), "Gain of the chain (what if)"), 0);
    const auto &curves = m_bench->page.plots().front()->content().curves;
    QVERIFY(std::ranges::find(curves, QString("U, what if"), &PlotCurve::name) != curves.end());
    press("whatIfReset");
    QVERIFY(!m_bench->control<QLabel>("whatIfResult")->isVisible());
    QCOMPARE(cell(all, "Sensitivity", 3), QString("–"));
}

void TestUncertaintyPage::trial_isTakenOver_asOneStep()
{
    tryU("Gain of the chain", "5");
    tryU("T1", "2 K");
    const QString tried = label("whatIfResult");
    QVERIFY(isEnabled("whatIfTakeOver"));
    const int steps = m_bench->session.undoStack().count();
    press("whatIfTakeOver");
    QCOMPARE(m_bench->session.undoStack().count(), steps + 1);
    QVERIFY(!isEnabled("whatIfTakeOver")); // it is there already
    const auto &budget = m_bench->recipe().uncertainty.budget;
    QVERIFY((budget
        == std::vector<BudgetEntry>{
            {"gain_relative", 0.05, "rectangular", {}}, {"t1_k", 2.0, "normal", {}}}));
    test::waitComputed(m_bench->session);
    // A run has said the same, and nothing is tried any more.
    QTRY_VERIFY(!m_bench->control<QLabel>("whatIfResult")->isVisible());
    QVERIFY2(tried.endsWith(label("uncertaintyResult").section('=', 1)), qPrintable(tried));
    QVERIFY(!isEnabled("whatIfReset"));
    m_bench->session.undoStack().undo();
    QVERIFY(m_bench->recipe().uncertainty.budget.empty());
}

void TestUncertaintyPage::trial_ofWhatNoBudgetStates()
{
    tryU("Attenuation along the tube", "0");
    QVERIFY(has("whatIfNote", "cannot state: Attenuation along the tube"));
    QVERIFY(!isEnabled("whatIfTakeOver"));
    QVERIFY(isEnabled("whatIfReset"));
    // Of the lines of three shots one is typed, and all follow.
    tryU("Noise of the level", "1 %");
    const ValueTable &lines = table("budgetTable");
    for (int shot = 1; shot <= 3; ++shot) {
        const QString name = QString("Noise of the level, shot %1").arg(shot);
        QVERIFY2(cell(lines, name, kU).endsWith(" %"), qPrintable(cell(lines, name, kU)));
        QVERIFY(cell(lines, name, kU).remove(" %").toDouble() > 0.9);
    }
}

void TestUncertaintyPage::trial_isRefused_orTakenBack()
{
    tryU("T1", "-1 K");
    QVERIFY(!isEnabled("whatIfReset"));
    tryU("T1", "warm");
    QVERIFY(!isEnabled("whatIfReset"));
    tryU("T1", "1 K");
    QVERIFY(isEnabled("whatIfReset"));
    QCOMPARE(label("whatIfNow"), QString("0.30 K"));
    tryU("T1", "0.3 K"); // as it is
    QVERIFY(!isEnabled("whatIfReset"));
}

void TestUncertaintyPage::row_choosesItsInput()
{
    ValueTable &lines = table("budgetTable");
    const auto *input = m_bench->control<QComboBox>("whatIfInput");
    lines.setCurrentCell(rowOf(lines, "p1"), 0);
    QCOMPARE(input->currentText(), QString("p1"));
    QCOMPARE(label("whatIfNow"), cell(lines, "p1", kU));
    // Another value has it too: it stays chosen.
    chooseText(*m_bench, "uncertaintyQuantity", "Sensitivity, level High");
    QCOMPARE(input->currentText(), QString("p1"));
}

void TestUncertaintyPage::wantedU_saysWhatIsInTheWay()
{
    const ValueTable &lines = table("budgetTable");
    m_bench->type("qt_spinbox_lineedit", "1.5"); // the field of U, wanted, is the first
    QVERIFY2(
        has("wantedNote", "Attenuation along the tube, u ≤ 0.00"), qPrintable(label("wantedNote")));
    QVERIFY(cell(lines, "Attenuation", kNeeded).startsWith("≤ 0.00"));
    QCOMPARE(cell(lines, "T1", kNeeded), QString("not enough alone"));
    m_bench->type("qt_spinbox_lineedit", "0.5");
    QVERIFY(has("wantedNote", "no input alone is enough"));
    QVERIFY(has("wantedNote", "Attenuation along the tube; "));
    m_bench->type("qt_spinbox_lineedit", "50");
    QVERIFY(has("wantedNote", "is reached"));
}

void TestUncertaintyPage::shots_areTold()
{
    QCOMPARE(table("shotsTable").rowCount(), 20);
    QVERIFY2(has("shotsNote", "never below"), qPrintable(label("shotsNote")));
    chooseText(*m_bench, "uncertaintyQuantity", "Natural frequency f₀");
    const auto &report = *m_bench->session.results().uncertainty;
    const ReportedValue &f0 = *report.find("f0_hz");
    QVERIFY(*withEndlessShots(f0).u < *f0.u);
    QCOMPARE(table("shotsTable").item(2, 3)->text(), QString("2")); // k
}

void TestUncertaintyPage::unknownStep_isSaid()
{
    Recipe recipe = m_bench->recipe();
    recipe.shock.step_Pa = 4e5;
    m_bench->session.apply(recipe, "step");
    test::waitComputed(m_bench->session);
    QTRY_VERIFY2(has("uncertaintyResult", "its uncertainty is not complete"),
        qPrintable(label("uncertaintyResult")));
    QCOMPARE(table("budgetTable").rowCount(), 0);
    QCOMPARE(table("shotsTable").rowCount(), 0);
    QVERIFY(!m_bench->control<QWidget>("whatIfU")->isEnabled());
    QCOMPARE(m_bench->page.status(), StageStatus::DoneWithCautions); // UNC-001 counts here
}

void TestUncertaintyPage::swedish_hasNoEnglishNumbers()
{
    m_bench.reset();
    const test::InSwedish swedish;
    m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
    QTRY_VERIFY_WITH_TIMEOUT(table("budgetTable").rowCount() > 5, 30000);
    const QRegularExpression point("\\d\\.\\d");
    for (const char *name : {"budgetTable", "allUncertainties", "shotsTable"})
        for (int row = 0; row < table(name).rowCount(); ++row)
            for (int column = 0; column < table(name).columnCount(); ++column)
                QVERIFY2(!table(name).item(row, column)->text().contains(point),
                    qPrintable(table(name).item(row, column)->text()));
    for (const char *name : {"uncertaintyResult", "wantedNote", "shotsNote", "whatIfNow"})
        QVERIFY2(!label(name).contains(point), qPrintable(label(name)));
    QVERIFY(rowOf(table("budgetTable"), "Provets") < 0);
    QVERIFY(rowOf(table("budgetTable"), "Dämpning") >= 0);
    m_bench.reset(); // before its language goes
}

DYNCAL_TEST(TestUncertaintyPage)
#include "tst_uncertainty_page.moc"
