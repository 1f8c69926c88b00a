// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What stands between a value and a wanted U; closed forms.

#include "core/uncertainty/wanted_u.h"
#include "core/uncertainty/what_if.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

bool isAbout(double found, double expected)
{
    return std::abs(found - expected) <= 1e-12 * std::abs(expected);
}

ReportedValue valueOfLines(double value, const std::vector<UncertaintyLine> &lines)
{
    ReportedValue reported{"sensitivity", value, "V/Pa", lines};
    combineLines(reported);
    return reported;
}

} // namespace

class TestWantedU : public QObject
{
    Q_OBJECT

private slots:
    /// u = 7 of 6, 3 and 2, of a value of 1000: U = 1.4 %.
    void eachAlone_isWhatPythagorasLeaves()
    {
        const ReportedValue reported = valueOfLines(
            -1000.0, {directLine("b", 3.0), directLine("a", 6.0), directLine("c", 2.0)});
        const auto way = wayToU(reported, {0.01, 2.0}); // u = 5
        QVERIFY(way && !way->isReached);
        QVERIFY(isAbout(way->wanted_u, 5.0));
        QCOMPARE(way->inputs.size(), std::size_t(3));
        QCOMPARE(way->inputs[0].quantity, std::string("a"));
        QVERIFY(isAbout(*way->inputs[0].factor, std::sqrt(25.0 - 9.0 - 4.0) / 6.0));
        QVERIFY(!way->inputs[1].factor); // without b: sqrt(40) > 5
        QVERIFY(!way->inputs[2].factor);
        QCOMPARE(way->toRemove, std::size_t(1));
        // And with that u it is reached, to the last digit.
        const double to = 6.0 * *way->inputs[0].factor;
        QVERIFY(isAbout(*withChanges(reported, {{"a", 6.0, to}}).u, 5.0));
    }

    void severalLarge_areTheSmallestSetTogether()
    {
        const ReportedValue reported = valueOfLines(1000.0,
            {directLine("a", 6.0), directLine("b", 6.0), directLine("c", 6.0),
                directLine("d", 1.0)});
        const auto way = wayToU(reported, {0.01, 2.0}); // u = 5
        for (const InputShare &input : way->inputs)
            QVERIFY(!input.factor);
        QCOMPARE(way->toRemove, std::size_t(3)); // 6 and 1 are still above 5
        QCOMPARE(wayToU(reported, {0.001, 2.0})->toRemove, std::size_t(4));
    }

    /// Three shots with an input of one name: they get better together.
    void linesOfOneName_areOneInput()
    {
        const ReportedValue reported = valueOfLines(
            100.0, {directLine("n", 2.0), directLine("n", 2.0), directLine("n", 1.0)});
        const auto way = wayToU(reported, {0.03, 2.0}); // u = 1.5 of 3
        QCOMPARE(way->inputs.size(), std::size_t(1));
        QVERIFY(isAbout(way->inputs[0].contribution, 3.0));
        QVERIFY(isAbout(*way->inputs[0].factor, 0.5));
    }

    void reached_saysHowMuchWorseEachMayBe()
    {
        const ReportedValue reported
            = valueOfLines(100.0, {directLine("a", 0.3), directLine("b", 0.4)});
        const auto way = wayToU(reported, {0.013, 2.0}); // u = 0.65 of 0.5
        QVERIFY(way->isReached);
        QCOMPARE(way->toRemove, std::size_t(0));
        QVERIFY(isAbout(*way->inputs[0].factor, std::sqrt(0.65 * 0.65 - 0.09) / 0.4));
        QVERIFY(*way->inputs[1].factor > 1.0);
        QVERIFY(wayToU(reported, {0.01, 2.0})->isReached); // exactly
    }

    void anotherK_asksForLess()
    {
        const ReportedValue reported = valueOfLines(100.0, {directLine("a", 1.0)});
        QVERIFY(isAbout(*wayToU(reported, {0.015, 2.0})->inputs[0].factor, 0.75));
        QVERIFY(isAbout(*wayToU(reported, {0.015, 3.0})->inputs[0].factor, 0.5));
    }

    void nothingToAsk()
    {
        ReportedValue reported = valueOfLines(0.0, {directLine("a", 1.0)});
        QVERIFY(!wayToU(reported, {}));
        reported = valueOfLines(1.0, {directLine("a", 1.0)});
        QVERIFY(!wayToU(reported, {0.0, 2.0}));
        reported.u.reset();
        QVERIFY(!wayToU(reported, {}));
        // A line of nothing neither helps nor counts.
        reported = valueOfLines(1.0, {directLine("a", 1.0), directLine("b", 0.0)});
        QVERIFY(!wayToU(reported, {})->inputs[1].factor);
        QCOMPARE(wayToU(reported, {})->toRemove, std::size_t(1));
    }
};

DYNCAL_TEST(TestWantedU)
#include "tst_wanted_u.moc"
