// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The laboratory's least U, typed on the page of the uncertainty, and what it does to every U.

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/stages/uncertainty/capability_words.h"
#include "ui/stages/uncertainty/uncertainty_page.h"

#include <QListWidget>
#include <QPushButton>
#include <QtTest>

#include <numbers>

using namespace dyncal;
using Bench = test::PageBench<test::ScriptedPage<UncertaintyPage>>;

class TestCapabilityPanel : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench;

    void chooseOf(const char *of) const
    {
        m_bench->choose("capabilityOf", m_bench->control<QComboBox>("capabilityOf")->findData(of));
    }
    const std::vector<CapabilityEntry> &cmc() const { return m_bench->recipe().uncertainty.cmc; }
    QListWidget &list() const { return *m_bench->control<QListWidget>("capabilityList"); }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->session.results().uncertainty, 30000);
    }
    void cleanup() { m_bench.reset(); }

    void added_holdsEveryU()
    {
        const double before = *m_bench->session.results().uncertainty->sensitivity->expanded();
        QVERIFY(!m_bench->isEnabled("capabilityAdd")); // no U yet
        m_bench->type("capabilityUValue", "20");
        m_bench->press("capabilityAdd");
        QCOMPARE(m_bench->steps(), 1);
        QVERIFY((cmc() == std::vector<CapabilityEntry>{{"sensitivity", 0.2}}));
        QCOMPARE(list().item(0)->text(), QString("Sensitivity: U ≥ 20 %"));
        const ReportedValue &held = *m_bench->session.results().uncertainty->sensitivity;
        QVERIFY(before < 0.19 * held.value);
        QVERIFY(std::abs(*held.expanded() / held.value - 0.2) < 1e-9);
        m_bench->session.undoStack().undo();
        test::waitComputed(m_bench->session);
        QCOMPARE(list().count(), 0);
        QCOMPARE(*m_bench->session.results().uncertainty->sensitivity->expanded(), before);
    }

    void rows_haveABand_andPhasesAnAngle()
    {
        QVERIFY(!m_bench->isEnabled("capabilityFrom"));
        chooseOf("magnitude");
        QVERIFY(m_bench->isEnabled("capabilityFrom"));
        m_bench->type("capabilityUValue", "2");
        m_bench->type("capabilityFromValue", "1");
        m_bench->type("capabilityToValue", "500 Hz"); // below the begin
        m_bench->press("capabilityAdd");
        QVERIFY2(refusalOnShow(m_bench->control<QPushButton>("capabilityAdd")).contains("larger"),
            qPrintable(refusalOnShow(m_bench->control<QPushButton>("capabilityAdd"))));
        QVERIFY(cmc().empty());
        m_bench->type("capabilityToValue", "10");
        m_bench->press("capabilityAdd");
        QVERIFY((cmc() == std::vector<CapabilityEntry>{{"magnitude", 0.02, true, 1e3, 1e4}}));
        QCOMPARE(
            list().item(0)->text(), QString("Magnitude of S(f): U ≥ 2 %, from 1 kHz to 10 kHz"));
        chooseOf("phase_rad");
        QVERIFY(!m_bench->isEnabled("capabilityIn"));
        QVERIFY(!m_bench->isEnabled("capabilityAdd")); // its U is typed anew
        m_bench->type("capabilityUValue", "1");
        m_bench->press("capabilityAdd");
        QVERIFY(std::abs(cmc()[1].expanded - std::numbers::pi / 180.0) < 1e-15);
    }

    void selected_isReplaced_orRemoved()
    {
        chooseOf("f0_hz");
        m_bench->choose("capabilityIn", 1);
        m_bench->type("capabilityUValue", "2");
        m_bench->press("capabilityAdd");
        QVERIFY((cmc() == std::vector<CapabilityEntry>{{"f0_hz", 2e3, false}}));
        chooseOf("sensitivity");
        m_bench->choose("capabilityIn", 0);
        m_bench->type("capabilityUValue", "3");
        m_bench->press("capabilityAdd");
        QCOMPARE(list().currentRow(), 1);
        list().setCurrentRow(0); // its values stand in the fields
        QCOMPARE(m_bench->control<QLineEdit>("capabilityUValue")->text(), QString("2"));
        QCOMPARE(m_bench->control<QComboBox>("capabilityOf")->currentData(), QVariant("f0_hz"));
        m_bench->type("capabilityUValue", "4");
        m_bench->press("capabilityReplace");
        QCOMPARE(cmc()[0].expanded, 4e3);
        QCOMPARE(cmc().size(), std::size_t(2));
        m_bench->press("capabilityRemove");
        QVERIFY((cmc() == std::vector<CapabilityEntry>{{"sensitivity", 0.03}}));
        m_bench->press("capabilityRemove");
        QVERIFY(cmc().empty());
        QVERIFY(!m_bench->isEnabled("capabilityRemove"));
        QCOMPARE(m_bench->steps(), 5);
    }

    void wrongNumbers_areRefused()
    {
        for (const char *text : {"0", "-1", "much", "1e12"}) {
            m_bench->type("capabilityUValue", text);
            QVERIFY2(!refusalOnShow(&list()).isEmpty(), text);
            QVERIFY2(!m_bench->isEnabled("capabilityAdd"), text);
        }
        QCOMPARE(m_bench->steps(), 0);
    }

    void words_ofEveryQuantity()
    {
        QVERIFY(capabilityText({"sensitivity", 1e-9, false}, "V/Pa").endsWith(" V/Pa"));
        QCOMPARE(capabilityText({"rise_time_s", 2e-6, false}, {}),
            QString("Rise time 10–90 %: U ≥ 2 µs"));
        QCOMPARE(
            capabilityText({"overshoot_percent", 2.0, false}, {}), QString("Overshoot: U ≥ 2 %"));
        QCOMPARE(capabilityText({"q", 0.5, false}, {}), QString("Quality factor Q: U ≥ 0.5"));
        QCOMPARE(capabilityText({"magnitude", 0.01, true, 2e3}, {}),
            QString("Magnitude of S(f): U ≥ 1 %, from 2 kHz"));
    }
};

DYNCAL_TEST(TestCapabilityPanel)
#include "tst_capability_panel.moc"
