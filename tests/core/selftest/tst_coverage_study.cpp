// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/coverage_study.h"
#include "core/selftest/virtual_calibration.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

class TestCoverageStudy : public QObject
{
    Q_OBJECT

private slots:
    /// Both kinds of check can fail from there on, and below one of them cannot: with n intervals
    /// none within U has the probability 0.05^n, and a u that is far too large the rms 0.
    void leastCalibrations_isTheFewestThatCanFail()
    {
        const Index least = leastCalibrations();
        const auto canFail = [](Index n) {
            const auto count = static_cast<double>(n);
            return std::pow(0.05, count) < 1e-3 && 3.2905 / std::sqrt(2.0 * count) < 1.0;
        };
        QVERIFY(canFail(least) && !canFail(least - 1));
        QCOMPARE(least, Index(6));
        for (const SelfCheck &check : coverageStudy(least)) {
            SelfCheck failed = check;
            failed.found = 0.0; // nothing within U; no error at all
            QVERIFY2(!failed.holds(), english(check.name).c_str());
        }
    }

    /// By another program's binomial distribution: P(X <= 32 of 40) = 7.1e-4, P(X <= 33) = 3.4e-3.
    void fewestInside_isTheBinomialBound()
    {
        QCOMPARE(fewestInside(40, 0.95, 1e-3), Index(33));
        QCOMPARE(fewestInside(10, 0.95, 1e-3), Index(6));
        QCOMPARE(fewestInside(100, 0.95, 1e-3), Index(87));
        QCOMPARE(fewestInside(40, 0.5, 0.05), Index(15));
        QCOMPARE(fewestInside(1, 0.95, 1e-3), Index(0));
    }

    /// The same run gives the same errors; another one has another truth.
    void runs_areReproducible()
    {
        const VirtualErrors one = virtualCalibration(3), again = virtualCalibration(3);
        const VirtualErrors other = virtualCalibration(4);
        for (std::size_t q = 0; q < kVirtualQuantities; ++q) {
            QVERIFY(std::isfinite(one[q].overU));
            QCOMPARE(one[q].overU, again[q].overU);
            QVERIFY(one[q].overU != other[q].overU);
            QCOMPARE(one[q].isInside, again[q].isInside);
        }
    }

    /// The study's rows are what its runs say, however many threads there were.
    void rows_areThoseOfTheRuns()
    {
        double inside = 0.0, squares = 0.0;
        for (Index run = 1; run <= 3; ++run) {
            const VirtualError error = virtualCalibration(run)[0];
            inside += error.isInside ? 1.0 : 0.0;
            squares += error.overU * error.overU;
        }
        const std::vector<SelfCheck> checks = coverageStudy(3);
        QCOMPARE(checks.size(), 2 * kVirtualQuantities);
        QCOMPARE(checks[0].found, inside);
        QVERIFY(isNear(checks[0].expected, 0.95 * 3.0));
        QVERIFY(isNear(checks[1].found, std::sqrt(squares / 3.0)));
        QCOMPARE(checks[1].expected, 1.0);
        for (const SelfCheck &check : checks)
            QCOMPARE(check.step, std::string(kCoverageStep));
    }

    void progress_rises_andAStopLeavesNothing()
    {
        double last = 0.0;
        JobControl control;
        control.progress = [&](double fraction) {
            QVERIFY(fraction > last);
            last = fraction;
        };
        QVERIFY(!coverageStudy(3, control).empty());
        QCOMPARE(last, 1.0);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(coverageStudy(3, {stop.get_token(), {}}).empty());
        for (const VirtualError &error : virtualCalibration(1, stop.get_token()))
            QVERIFY(std::isnan(error.overU) && !error.isInside);
    }

    /// 40 runs within their bounds; one that fails is counted as outside and spoils the rms.
    void study_holds()
    {
        for (const SelfCheck &check : coverageStudy(40))
            QVERIFY2(check.holds(), english(check.name).c_str());
    }
};

DYNCAL_TEST(TestCoverageStudy)
#include "tst_coverage_study.moc"
