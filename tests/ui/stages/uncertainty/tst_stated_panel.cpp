// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The u that the budget states, with the reference of each, typed on the page of the uncertainty.

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/stages/uncertainty/uncertainty_page.h"

#include <QCalendarWidget>
#include <QListWidget>
#include <QToolButton>
#include <QtTest>

using namespace dyncal;
using Bench = test::PageBench<test::ScriptedPage<UncertaintyPage>>;

class TestStatedPanel : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench;

    const std::vector<BudgetEntry> &budget() const { return m_bench->recipe().uncertainty.budget; }
    QListWidget &list() const { return *m_bench->control<QListWidget>("statedList"); }
    QString due() const { return m_bench->control<QLineEdit>("statedDue")->text(); }
    void state(const std::vector<BudgetEntry> &entries) const
    {
        Recipe recipe = m_bench->recipe();
        recipe.uncertainty.budget = entries;
        m_bench->session.apply(recipe, "as a file states it");
        test::waitComputed(m_bench->session);
    }
    void chooseDay(QDate day) const
    {
        m_bench->control<QToolButton>("calendar_statedDue")->click();
        emit m_bench->control<QCalendarWidget>({})->clicked(day);
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->session.results().uncertainty, 30000);
    }
    void cleanup() { m_bench.reset(); }

    void dueDate_isChosenInACalendar_andUndone()
    {
        const BudgetEntry stated{"p1_pa", 50.0, "normal", {}, "R-1", "2026-01-31"};
        state({stated, {"t1_k", 0.2, "rectangular", 12.0}});
        QCOMPARE(list().item(0)->text(), QString("p1: u = 50 Pa, certificate R-1, due 2026-01-31"));
        list().setCurrentRow(0);
        QCOMPARE(due(), QString("2026-01-31"));
        chooseDay(QDate(2027, 2, 28));
        QVERIFY(budget()[0] == stated); // until it is put in the entry's place
        m_bench->press("statedReplace");
        BudgetEntry later = stated;
        later.due = "2027-02-28";
        QVERIFY(budget()[0] == later);
        QCOMPARE(list().item(0)->text(), QString("p1: u = 50 Pa, certificate R-1, due 2027-02-28"));
        m_bench->session.undoStack().undo();
        test::waitComputed(m_bench->session);
        QVERIFY(budget()[0] == stated);
        QCOMPARE(due(), QString("2026-01-31"));
    }

    void noDate_isRefused_andTakenOut()
    {
        state({{"p1_pa", 50.0, "normal", {}, "R-1", "2026-01-31"}});
        list().setCurrentRow(0);
        m_bench->type("statedDue", "2026-02-30");
        m_bench->press("statedReplace");
        const QString said = refusalOnShow(m_bench->control<QPushButton>("statedReplace"));
        QVERIFY2(said.contains("2026-02-30") || said.contains("due date"), qPrintable(said));
        QCOMPARE(budget()[0].due, std::string("2026-01-31"));
        m_bench->control<QLineEdit>("statedDue")->clear();
        m_bench->press("statedReplace");
        QCOMPARE(budget()[0].due, std::string());
    }

    void everyPartOfAnEntry_isTyped()
    {
        QVERIFY(!m_bench->isEnabled("statedAdd")); // no u yet
        auto *of = m_bench->control<QComboBox>("statedOf");
        m_bench->choose("statedOf", of->findData("distance_m"));
        QCOMPARE(of->currentText(), QString("Distance, all places"));
        m_bench->type("statedUValue", "0.2 mm");
        m_bench->choose("statedDistribution", 1);
        m_bench->type("statedDofValue", "20");
        m_bench->type("statedCertificate", " R-7 ");
        m_bench->press("statedAdd");
        QVERIFY((budget()
            == std::vector<BudgetEntry>{{"distance_m", 2e-4, "rectangular", 20.0, "R-7"}}));
        m_bench->choose("statedOf", of->findData("gain_relative"));
        QVERIFY(!m_bench->isEnabled("statedAdd")); // the u was of the distance
        m_bench->type("statedUValue", "0.5");
        m_bench->press("statedAdd");
        QCOMPARE(budget().at(1).u, 0.005);
        QCOMPARE(list().item(1)->text(), QString("Gain of the chain: u = 0.5 %, certificate R-7"));
        m_bench->press("statedAdd"); // each quantity once
        QVERIFY(!refusalOnShow(m_bench->control<QPushButton>("statedAdd")).isEmpty());
        QCOMPARE(budget().size(), std::size_t(2));
        m_bench->press("statedRemove");
        QCOMPARE(budget().size(), std::size_t(1));
    }

    /// What stands half typed in the fields is not lost when another part of the recipe changes.
    void anotherChange_leavesTheFields()
    {
        state({{"p1_pa", 50.0, "normal", {}, "R-1", "2026-01-31"}});
        list().setCurrentRow(0);
        m_bench->control<QLineEdit>("statedDue")->setText("2027-0");
        Recipe recipe = m_bench->recipe();
        recipe.certificate.fields["customer"] = "Customer Ltd";
        m_bench->session.apply(recipe, "another");
        QCOMPARE(due(), QString("2027-0"));
    }
};

DYNCAL_TEST(TestStatedPanel)
#include "tst_stated_panel.moc"
