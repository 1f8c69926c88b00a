// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A short version of tests/accuracy/pole_coverage (docs/accuracy.md).

#include "tests/support/pole_coverage.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

class TestPoleCoverage : public QObject
{
    Q_OBJECT

private slots:
    void statedIntervals_holdTheTruth_data()
    {
        QTest::addColumn<int>("row");
        // One of each kind: ringing at few samples per period, well damped, coloured noise.
        for (const int row : {1, 7, 8})
            QTest::newRow(testing::coverageCases()[static_cast<std::size_t>(row)].name.c_str())
                << row;
    }
    void statedIntervals_holdTheTruth()
    {
        // 100 runs at 95 %: 88 to 100 hold it but for 0.5 %; the seeds are fixed.
        constexpr int kRuns = 100;
        constexpr int kFewest = 88;
        // rms of 100 standard normal numbers: 1 with sd 0.07; four of them.
        constexpr double kScatter = 0.28;
        QFETCH(int, row);
        const testing::PoleCoverage c = testing::poleCoverage(
            testing::coverageCases()[static_cast<std::size_t>(row)], kRuns, 5000);
        const double rmsF0 = std::sqrt(c.squaresF0 / kRuns);
        const double rmsZeta = std::sqrt(c.squaresZeta / kRuns);
        qInfo("f0 in %d, zeta in %d of %d; rms error/u %.2f, %.2f", c.insideF0, c.insideZeta, kRuns,
            rmsF0, rmsZeta);
        QCOMPARE(c.failed, 0);
        QVERIFY(c.insideF0 >= kFewest && c.insideZeta >= kFewest);
        QVERIFY(std::abs(rmsF0 - 1.0) < kScatter && std::abs(rmsZeta - 1.0) < kScatter);
        QVERIFY(c.heterogeneous <= 4); // of 100 at 1 %
    }
};

DYNCAL_TEST(TestPoleCoverage)
#include "tst_pole_coverage.moc"
