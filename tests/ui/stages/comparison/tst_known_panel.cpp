// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of other calibrations, typed on the page of comparison.

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/comparison/comparison_page.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/value_table.h"

#include <QListWidget>
#include <QPushButton>
#include <QtTest>

using namespace dyncal;

namespace {

Prompts &unasked()
{
    static Prompts prompts;
    prompts.setScripted();
    return prompts;
}

class PageOfKnown : public ComparisonPage
{
public:
    explicit PageOfKnown(Session &session)
        : ComparisonPage(session, unasked())
    {
    }
};
using Bench = test::PageBench<PageOfKnown>;

} // namespace

class TestKnownPanel : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench;

    QListWidget &list() const { return *m_bench->control<QListWidget>("knownList"); }
    const std::vector<KnownSensitivity> &known() const { return m_bench->recipe().response.known; }
    double sensitivity() const
    {
        return m_bench->session.results().uncertainty->sensitivity->value;
    }
    void type(const char *label, double value, double U) const
    {
        m_bench->type("knownLabel", label);
        m_bench->type("knownMagnitudeValue", QString::number(value, 'g', 12));
        m_bench->type("knownUValue", QString::number(U, 'g', 12));
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->session.results().uncertainty, 30000);
        test::waitComputed(m_bench->session);
    }
    void cleanup() { m_bench.reset(); }

    void added_isCompared_inListTableAndFinding()
    {
        QVERIFY(!m_bench->isEnabled("knownAdd"));
        QCOMPARE(m_bench->control<QLineEdit>("knownUnit")->text(), QString("V/Pa"));
        type("works", 1.001 * sensitivity(), 0.001 * sensitivity());
        m_bench->press("knownAdd");
        QCOMPARE(known().size(), std::size_t(1));
        QVERIFY(std::abs(known()[0].u / (0.0005 * sensitivity()) - 1.0) < 1e-9); // k = 2
        const KnownValue &found = m_bench->session.results().uncertainty->known.at(0);
        QVERIFY(found.isJoined());
        QVERIFY(list().item(0)->text().startsWith("works, static: "));
        type("odd", 1.5 * sensitivity(), 0.001 * sensitivity());
        m_bench->press("knownAdd");
        const auto &findings = m_bench->session.results().uncertainty->findings;
        QVERIFY(std::ranges::count(findings, std::string("UNC-004"), &Finding::id) == 1);
        m_bench->session.undoStack().undo();
        test::waitComputed(m_bench->session);
        QCOMPARE(list().count(), 1);
    }

    void selected_isReplaced_orRemoved()
    {
        type("works", sensitivity(), 0.01 * sensitivity());
        m_bench->type("knownCertificate", "K 7");
        m_bench->type("knownFrequencyValue", "0.8");
        m_bench->press("knownAdd");
        QCOMPARE(known()[0].frequency_Hz, 800.0);
        QCOMPARE(known()[0].certificate, std::string("K 7"));
        m_bench->type("knownLabel", "valve");
        m_bench->press("knownReplace");
        QCOMPARE(known()[0].label, std::string("valve"));
        QCOMPARE(known().size(), std::size_t(1));
        m_bench->press("knownRemove");
        QVERIFY(known().empty());
        QVERIFY(!m_bench->isEnabled("knownRemove"));
    }

    void anotherUnit_isConverted_orTold()
    {
        type("works", 1e8 * sensitivity(), 1e6 * sensitivity());
        m_bench->type("knownUnit", "mV/bar"); // 1e-3 / 1e5
        m_bench->press("knownAdd");
        QVERIFY(m_bench->session.results().uncertainty->known.at(0).isJoined());
        m_bench->type("knownUnit", "pC/bar");
        m_bench->press("knownReplace");
        const auto &report = *m_bench->session.results().uncertainty;
        QVERIFY(!report.known.at(0).isCompared());
        QCOMPARE(report.findings.back().id, std::string("UNC-005"));
    }
};

DYNCAL_TEST(TestKnownPanel)
#include "tst_known_panel.moc"
