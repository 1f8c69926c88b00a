// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The statement of conformity, chosen and typed on the page of the certificate.

#include "core/certificate/certificate_conformity.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/certificate/certificate_page.h"
#include "ui/stages/frame/refusal_note.h"

#include <QLabel>
#include <QtTest>

using namespace dyncal;
using Bench = test::PageBench<test::DatedPage<CertificatePage>>;

class TestDecisionPanel : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench;

    const std::optional<DecisionSettings> &decision() const
    {
        return m_bench->recipe().certificate.decision;
    }
    QLabel &label(const char *name) const { return *m_bench->control<QLabel>(name); }
    QString refusal() const { return refusalOnShow(m_bench->control<QWidget>("decisionTo")); }
    void clear(const char *name) const
    {
        auto *edit = m_bench->control<QLineEdit>(name);
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    void claim(const char *within, const char *from, const char *to) const
    {
        m_bench->type("decisionWithinValue", within);
        m_bench->type("decisionFromValue", from);
        m_bench->type("decisionToValue", to);
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { m_bench = std::make_unique<Bench>(); }
    void cleanup() { m_bench.reset(); }

    void rule_waitsForItsClaim()
    {
        QVERIFY(!m_bench->isEnabled("decisionWithin"));
        m_bench->choose("decisionRule", 2);
        QVERIFY(m_bench->isEnabled("decisionWithin"));
        QCOMPARE(m_bench->steps(), 0);
        m_bench->type("decisionWithinValue", "5");
        QVERIFY(label("decisionNote").text().contains("From"));
        QVERIFY(!decision());
        m_bench->type("decisionFromValue", "1");
        m_bench->type("decisionToValue", "100");
        QCOMPARE(m_bench->steps(), 1);
        QVERIFY((decision() == DecisionSettings{DecisionRule::GuardBand, 5.0, 1e3, 1e5}));
        QVERIFY(label("decisionNote").text().isEmpty());
        m_bench->session.undoStack().undo();
        QCOMPARE(m_bench->control<QComboBox>("decisionRule")->currentIndex(), 0);
        QCOMPARE(m_bench->control<QLineEdit>("decisionToValue")->text(), QString());
        QVERIFY(!m_bench->isEnabled("decisionWithin"));
    }

    void risk_countsForItsRuleAlone()
    {
        m_bench->choose("decisionRule", 1);
        claim("5", "1", "100");
        QVERIFY(!m_bench->isEnabled("decisionRisk"));
        m_bench->choose("decisionRule", 3);
        QVERIFY(m_bench->isEnabled("decisionRisk"));
        QCOMPARE(m_bench->control<QLineEdit>("decisionRiskValue")->text(), QString("5"));
        m_bench->type("decisionRiskValue", "2.5 %");
        QCOMPARE(decision()->maxRisk_percent, 2.5);
        m_bench->type("decisionRiskValue", "50"); // a coin would do
        QVERIFY(!refusal().isEmpty());
        QCOMPARE(decision()->maxRisk_percent, 2.5);
        clear("decisionRiskValue");
        QCOMPARE(decision()->maxRisk_percent, 5.0);
        m_bench->choose("decisionRule", 0);
        QVERIFY(!decision());
        QVERIFY(!m_bench->isEnabled("decisionRisk"));
    }

    void wrongClaims_areRefused()
    {
        m_bench->choose("decisionRule", 1);
        claim("5", "10", "1");
        QVERIFY2(refusal().contains("highest frequency of the claim"), qPrintable(refusal()));
        QVERIFY(!decision());
        QCOMPARE(m_bench->control<QLineEdit>("decisionToValue")->text(), QString());
        for (const char *text : {"0", "-5", "wide"}) {
            m_bench->type("decisionWithinValue", text);
            QVERIFY2(!refusal().isEmpty(), text);
        }
        QCOMPARE(m_bench->steps(), 0);
        m_bench->type("decisionToValue", "100");
        QCOMPARE(decision()->within_percent, 5.0);
        clear("decisionToValue"); // the others stand
        QVERIFY(refusal().contains("needed"));
        QCOMPARE(decision()->to_Hz, 1e5);
    }

    /// What the certificate will say, in its words.
    void outcome_isTheCertificates()
    {
        m_bench = std::make_unique<Bench>(testing::simulatedExample(1e7, 0.006));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->session.results().uncertainty, 30000);
        QVERIFY(label("decisionOutcome").text().isEmpty());
        m_bench->choose("decisionRule", 1);
        claim("50", "2", "50");
        const auto section = conformitySection(m_bench->session.results(), m_bench->recipe());
        QVERIFY(section);
        for (const CertificateField &field : section->fields) {
            const bool isShown = label("decisionOutcome")
                                     .text()
                                     .contains(QString::fromStdString(english(field.value)));
            QCOMPARE(isShown, field.id == "verdict" || field.id == "worst");
        }
        QVERIFY2(label("decisionOutcome").text().contains("Result: conforms"),
            qPrintable(label("decisionOutcome").text()));
        m_bench->type("decisionToValue", "100 MHz");
        QVERIFY2(!label("decisionOutcome").text().contains("Result: conforms"),
            qPrintable(label("decisionOutcome").text()));
    }
};

DYNCAL_TEST(TestDecisionPanel)
#include "tst_decision_panel.moc"
