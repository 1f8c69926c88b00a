// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/finding.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

class TestFinding : public QObject
{
    Q_OBJECT

private slots:
    void whatIsThere_isNotAddedAgain()
    {
        Findings findings;
        addOnce(findings, {.id = "CAP-030", .shot = 1});
        addOnce(findings, {.id = "CAP-030", .shot = 1});
        QCOMPARE(findings.size(), std::size_t(1));
        addOnce(findings, {.id = "CAP-030", .shot = 2});
        addOnce(findings, {.id = "CAP-030", .shot = 1, .value = 2.0});
        QCOMPARE(findings.size(), std::size_t(3));
        QCOMPARE(findings[1].shot, Index(2)); // in the order of their coming
    }

    void worst_isTheMostSevere()
    {
        QVERIFY(worstSeverity({}) == Severity::Info);
        Findings findings{{.id = "a", .severity = Severity::Caution}, {.id = "b"}};
        QVERIFY(worstSeverity(findings) == Severity::Caution);
        findings.push_back({.id = "c", .severity = Severity::Block});
        QVERIFY(worstSeverity(findings) == Severity::Block);
    }

    void words_areThoseOfResults()
    {
        QCOMPARE(severityName(Severity::Block), "block");
        QCOMPARE(findingCauseName(FindingCause::Drift), "drift");
        QCOMPARE(findingCauseName(FindingCause::Order), "order");
    }
};

DYNCAL_TEST(TestFinding)
#include "tst_finding.moc"
