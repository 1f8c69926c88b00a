// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page says of a comparison, from values written down.

#include "tests/support/made_comparison.h"
#include "tests/support/test_program.h"
#include "ui/stages/comparison/comparison_words.h"

#include <QtTest>

using namespace dyncal;

namespace {

CalibrationResults with(const ComparisonResult &comparison)
{
    CalibrationResults results;
    results.comparison = std::make_shared<const ComparisonResult>(comparison);
    return results;
}

const std::vector<double> kTen(10, 2.0);

/// Ten rows, the first `beyond` of them beyond their U.
ComparisonResult tenRows(int beyond, double difference)
{
    std::vector<double> e_n(10, 0.2);
    std::fill_n(e_n.begin(), beyond, -1.7);
    return testing::comparisonOf(kTen, kTen, e_n, difference);
}

ConsistencyResult oneCheck(double b)
{
    ConsistencyResult checks;
    WayComparison check;
    check.value_a = 1.0;
    check.value_b = b;
    check.u = 0.1;
    checks.checks.push_back(check);
    return checks;
}

} // namespace

class TestComparisonWords : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void nothingYet_isNothing()
    {
        QVERIFY(comparisonVerdict({}).isEmpty());
        QVERIFY(comparisonAdvice({}).isEmpty());
        QVERIFY(comparisonTable(nullptr).rows.isEmpty());
    }

    void notAskedFor_saysHow()
    {
        QVERIFY(comparisonVerdict(with({})).startsWith("Nothing is compared."));
        QVERIFY(comparisonAdvice(with({})).isEmpty());
    }

    void agreement_isSaidWithItsNumbers()
    {
        const auto results = with(tenRows(0, 0.0124));
        const QString said = comparisonVerdict(results);
        QVERIFY2(said.contains("agree") && said.contains("+1.24 %") && said.contains("2 %")
                && said.contains("Eₙ = 0.62") && said.contains("none of 10"),
            qPrintable(said));
        QVERIFY(comparisonAdvice(results).isEmpty());
    }

    /// One of ten may be chance, two are not.
    void singleRows_areToldFromTheMean()
    {
        const QString said = comparisonVerdict(with(tenRows(1, 0.01)));
        QVERIFY2(
            said.contains("agree") && said.contains("At 1 of 10 frequencies"), qPrintable(said));
        QVERIFY(comparisonAdvice(with(tenRows(1, 0.01))).isEmpty());
        const QString advice = comparisonAdvice(with(tenRows(2, 0.01)));
        QVERIFY2(advice.startsWith("The mean agrees"), qPrintable(advice));
    }

    void contradiction_saysWhatToDo_andWhereToBegin()
    {
        auto results = with(tenRows(9, -0.0301));
        QVERIFY(comparisonVerdict(results).contains("contradict each other"));
        QVERIFY(comparisonVerdict(results).contains("-3.01 %"));
        QVERIFY(comparisonAdvice(results).contains("date of its certificate"));
        QVERIFY(!comparisonAdvice(results).contains("Checks"));
        results.checks = std::make_shared<const ConsistencyResult>(oneCheck(1.05));
        QVERIFY(comparisonAdvice(results).contains("begin with the transducer"));
        results.checks = std::make_shared<const ConsistencyResult>(oneCheck(2.0));
        QVERIFY(comparisonAdvice(results).contains("begin there"));
    }

    void stepWithoutU_standsAlone()
    {
        ComparisonResult alone = tenRows(0, 0.0);
        alone.againstStep.reset();
        QVERIFY(comparisonVerdict(with(alone)).contains("stands alone"));
        QVERIFY(comparisonAdvice(with(alone)).isEmpty());
        QCOMPARE(comparisonTable(&alone).rows.size(), qsizetype(10)); // no mean
    }

    void table_hasEveryRow_andTheMeanFirst()
    {
        const ComparisonResult comparison
            = testing::comparisonOf({2.0, 2.1}, {2.02, kUnknown}, {0.4, kUnknown}, 0.01);
        const ShownTable table = comparisonTable(&comparison);
        QCOMPARE(table.rows.size(), qsizetype(3));
        QCOMPARE(table.headers.size(), table.rows[1].size());
        QCOMPARE(table.rows[0][5], QString("+1 %"));
        QCOMPARE(table.rows[1],
            (QStringList{"1 kHz", "2.000 V/Pa", "0.020 V/Pa", "2.020 V/Pa", "0.040 V/Pa",
                "+0.995 %", "0.40"}));
        QCOMPARE(table.rows[2][3], QString("–"));
        QCOMPARE(table.rows[2].mid(5), (QStringList{"–", "–"}));
    }

    void source_isSaid()
    {
        const CertifiedReference certified{
            ReferenceSensitivity::fromTable({{1e3, 2e-7, 1e-9}, {1e5, 3e-7, 1e-9}}).value(),
            "K-17"};
        const QString said = sourceSentence(certified, "V/Pa");
        QVERIFY2(said.startsWith("Certificate K-17, from 1 kHz to 100 kHz; at 1 kHz: 200"),
            qPrintable(said));
        QVERIFY(sourceSentence({certified.sensitivity, {}}, "1").startsWith("Table"));
    }
};

DYNCAL_TEST(TestComparisonWords)
#include "tst_comparison_words.moc"
