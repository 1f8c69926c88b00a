// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_budget.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

UncertaintyLine lineOf(const char *quantity, double contribution, Index shot = 0)
{
    UncertaintyLine line{.quantity = quantity, .shot = shot, .u = contribution};
    line.contribution = contribution;
    return line;
}

std::string rowText(const CertificateTable &table, std::size_t row)
{
    std::string text;
    for (const Message &cell : table.rows[row])
        text += (text.empty() ? "" : " | ") + english(cell);
    return text;
}

} // namespace

/// The budget as it is printed.
class TestCertificateBudget : public QObject
{
    Q_OBJECT

private slots:
    /// 6, 3 and (shots 2 and 2) of a value of 1000: squares 36, 9 and 8 of 53, and one of 0.0001.
    void sources_standByTheirShare_shotsTogether_smallOnesInOneLine()
    {
        ReportedValue reported{"sensitivity", 1000.0, "V/Pa"};
        reported.lines = {lineOf("noise", 2.0, 1), lineOf("noise", -2.0, 2), lineOf("t1_k", 6.0),
            lineOf("p1_pa", -3.0), lineOf("gamma", 0.01)};
        combineLines(reported);
        const auto table = budgetTable(reported);
        QVERIFY(table.has_value());
        QCOMPARE(table->rows.size(), std::size_t(4));
        QCOMPARE(rowText(*table, 0), std::string("initial temperature | 0.6 % | 68 %"));
        QCOMPARE(rowText(*table, 1), std::string("initial pressure | 0.3 % | 17 %"));
        QCOMPARE(rowText(*table, 2), std::string("noise | 0.28 % | 15 %"));
        QCOMPARE(rowText(*table, 3), std::string("all others together | 0.001 % | 0.00019 %"));
    }

    void withoutUncertainty_thereIsNone()
    {
        ReportedValue reported{"sensitivity", 1000.0, "V/Pa"};
        reported.lines = {lineOf("t1_k", 6.0)};
        QVERIFY(!budgetTable(reported));
        reported.u = 6.0;
        QVERIFY(budgetTable(reported));
        reported.value = 0.0;
        QVERIFY(!budgetTable(reported));
    }
};

DYNCAL_TEST(TestCertificateBudget)
#include "tst_certificate_budget.moc"
