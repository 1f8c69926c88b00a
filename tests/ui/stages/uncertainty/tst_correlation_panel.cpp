// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Inputs that err together, typed on the page of the uncertainty, and what they do to U.

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/stages/uncertainty/correlation_panel.h"
#include "ui/stages/uncertainty/uncertainty_page.h"

#include <QListWidget>
#include <QPushButton>
#include <QtTest>

using namespace dyncal;
using Bench = test::PageBench<test::ScriptedPage<UncertaintyPage>>;

class TestCorrelationPanel : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench;

    void choose(const char *box, const char *quantity) const
    {
        m_bench->choose(box, m_bench->control<QComboBox>(box)->findData(quantity));
    }
    void type(const char *of, const char *with, const char *r) const
    {
        choose("correlationOf", of);
        choose("correlationWith", with);
        m_bench->type("correlationRValue", r);
    }
    const std::vector<CorrelationEntry> &all() const
    {
        return m_bench->recipe().uncertainty.correlations;
    }
    double sensitivityU() const { return *m_bench->session.results().uncertainty->sensitivity->u; }
    QListWidget &list() const { return *m_bench->control<QListWidget>("correlationList"); }
    QString refusal() const
    {
        return refusalOnShow(m_bench->control<QPushButton>("correlationAdd"));
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        Recipe recipe;
        recipe.uncertainty.budget = {{"p1_pa", 400.0}, {"t1_k", 1.5}, {"gain_relative", 0.004}};
        m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
        m_bench->session.apply(recipe, "budget");
        test::waitComputed(m_bench->session);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->session.results().uncertainty, 30000);
    }
    void cleanup() { m_bench.reset(); }

    void added_changesU_andIsUndone()
    {
        const double before = sensitivityU();
        QVERIFY(!m_bench->isEnabled("correlationAdd")); // no r yet
        type("t1_k", "gain_relative", "-0.9");
        m_bench->press("correlationAdd");
        QVERIFY((all() == std::vector<CorrelationEntry>{{"t1_k", "gain_relative", -0.9}}));
        QVERIFY2(list().item(0)->text().endsWith(": r = -0.9"), qPrintable(list().item(0)->text()));
        QVERIFY(std::abs(sensitivityU() / before - 1.0) > 0.01);
        m_bench->session.undoStack().undo();
        test::waitComputed(m_bench->session);
        QCOMPARE(list().count(), 0);
        QCOMPARE(sensitivityU(), before);
    }

    void selected_isReplaced_orRemoved()
    {
        type("t1_k", "gain_relative", "0.5");
        m_bench->press("correlationAdd");
        type("p1_pa", "t1_k", "0.2");
        m_bench->press("correlationAdd");
        list().setCurrentRow(0); // its values stand in the fields
        QCOMPARE(m_bench->control<QComboBox>("correlationWith")->currentData(),
            QVariant("gain_relative"));
        QCOMPARE(m_bench->control<QLineEdit>("correlationRValue")->text(), QString("0.5"));
        m_bench->type("correlationRValue", "0.4");
        m_bench->press("correlationReplace");
        QCOMPARE(all()[0].coefficient, 0.4);
        m_bench->press("correlationRemove");
        QVERIFY((all() == std::vector<CorrelationEntry>{{"p1_pa", "t1_k", 0.2}}));
    }

    void impossible_isRefused_withItsReason()
    {
        type("t1_k", "gain_relative", "0.5");
        m_bench->press("correlationAdd");
        type("gain_relative", "t1_k", "0.1"); // the same pair
        m_bench->press("correlationAdd");
        QVERIFY2(refusal().contains("twice"), qPrintable(refusal()));
        m_bench->type("correlationRValue", "1.5");
        QVERIFY(!m_bench->isEnabled("correlationAdd") || all().size() == 1);
        type("t1_k", "p1_pa", "0.5");
        m_bench->press("correlationAdd");
        type("gain_relative", "p1_pa", "-1");
        m_bench->press("correlationAdd");
        QVERIFY2(refusal().contains("contradict"), qPrintable(refusal()));
        QCOMPARE(all().size(), std::size_t(2));
    }

    void aQuantityWithItself_isNoPair_butVelocitiesOfShots()
    {
        type("t1_k", "t1_k", "0.5");
        QVERIFY(!m_bench->isEnabled("correlationAdd"));
        type("velocity_m_s", "velocity_m_s", "0.5");
        QVERIFY(m_bench->isEnabled("correlationAdd"));
    }
};

DYNCAL_TEST(TestCorrelationPanel)
#include "tst_correlation_panel.moc"
