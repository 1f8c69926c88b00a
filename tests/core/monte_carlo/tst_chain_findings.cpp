// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// UNC-003: raised where the two propagations differ by more than 5 %, and only there.

#include "core/monte_carlo/chain_findings.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

/// Monte Carlo gives U_drawn, known to +-`open`; the law U_gum.
DrawnValue value(const char *of, double U_drawn, double U_gum, double open = 0.0)
{
    DrawnValue one{of, "Hz", 1000.0, {}, {}};
    one.drawn.expanded = U_drawn;
    one.drawn.leastExpanded = U_drawn - open;
    one.drawn.mostExpanded = U_drawn + open;
    one.gum.u = 0.5 * U_gum;
    one.gum.k = 2.0;
    one.gum.low = one.value - U_gum;
    one.gum.high = one.value + U_gum;
    return one;
}

Findings judged(const std::vector<DrawnValue> &values)
{
    return judgeChain(values, {}, {});
}

} // namespace

class TestChainFindings : public QObject
{
    Q_OBJECT

private slots:
    void agreement_isNotTold()
    {
        QVERIFY(judged({}).empty());
        QVERIFY(judged({value("f0_hz", 20.9, 20.0), value("q", 19.1, 20.0)}).empty());
    }

    void tooSmallAU_isACaution()
    {
        const Findings found
            = judged({value("f0_hz", 20.0, 20.0), value("rise_time_s", 29.0, 24.0)});
        QCOMPARE(std::ssize(found), Index(1));
        QCOMPARE(found[0].id, std::string("UNC-003"));
        QCOMPARE(found[0].severity, Severity::Caution);
        const QString words = QString::fromStdString(english(found[0].message));
        QVERIFY2(
            words.startsWith(
                "Rise time, 10 % to 90 %: Monte Carlo gives U = 2.9 %, the law of propagation only 2.4 %: use Monte Carlo."),
            qPrintable(words));
        QVERIFY2(words.contains("1 of 2 values"), qPrintable(words));
        QVERIFY(std::abs(*found[0].value - 20.8333) < 1e-3);
        QCOMPARE(*found[0].limit, 5.0);
    }

    void tooLargeAU_isANote()
    {
        const Findings found = judged({value("f0_hz", 18.0, 20.0), value("q", 10.0, 20.0)});
        QCOMPARE(std::ssize(found), Index(1));
        QCOMPARE(found[0].severity, Severity::Info);
        QVERIFY(english(found[0].message).starts_with("Quality factor: Monte Carlo gives U = 1 %"));
        QVERIFY(english(found[0].message).find("2 of 2 values") != std::string::npos);
    }

    /// A front that nobody stated is told of for what it is.
    void unknownFront_isANoteWithItsCause()
    {
        DrawnValue row = value("minus_3_db_hz", 29.0, 24.0);
        row.gum.largest = "front_unknown";
        const Findings found = judged({row, value("rise_time_s", 40.0, 24.0)});
        QCOMPARE(std::ssize(found), Index(2));
        QCOMPARE(found[0].severity, Severity::Caution);
        QVERIFY(english(found[0].message).starts_with("Rise time"));
        QCOMPARE(found[1].severity, Severity::Info);
        QVERIFY(english(found[1].message)
                    .starts_with("Magnitude above -3 dB up to: Monte Carlo gives U = 2.9 %"));
        QVERIFY(found[1].causes == std::vector{FindingCause::Front});
        row.gum.largest = "noise";
        QCOMPARE(judged({row})[0].severity, Severity::Caution);
    }

    /// 100 trials do not show 10 %.
    void whatTheTrialsLeaveOpen_isNotTold()
    {
        QVERIFY(judged({value("f0_hz", 22.0, 20.0, 2.0), value("q", 18.0, 20.0, 2.0)}).empty());
        QCOMPARE(std::ssize(judged({value("f0_hz", 22.0, 20.0, 0.5)})), Index(1));
    }

    void undefinedTrials_areNotCompared()
    {
        DrawnValue one = value("within_5_percent_hz", kUnknown, 20.0);
        one.drawn.undefined = 3;
        one.drawn.leastExpanded = one.drawn.mostExpanded = kUnknown;
        QVERIFY(judged({one}).empty());
    }

    static RefitCheck refits()
    {
        return {50, 0,
            {{"f0_hz", 1.1, 1.0, 0.1, true}, {"q", 2.0, 1.0, 0.0, false},
                {"rise_time_s", 1.0, 1.0, 0.9, false}}};
    }

    void refitsThatDisagree_areACaution()
    {
        const Findings found = judgeRefits(refits());
        QCOMPARE(std::ssize(found), Index(1));
        QCOMPARE(found[0].id, std::string("UNC-006"));
        QCOMPARE(found[0].severity, Severity::Caution);
        const QString words = QString::fromStdString(english(found[0].message));
        QVERIFY2(words.startsWith(
                     "Rise time, 10 % to 90 %: 50 refits of simulated records are 1 times as "
                     "uncertain as the model's covariance has it, and 0.9 of that u"),
            qPrintable(words));
        RefitCheck spread = refits();
        spread.values[2].agrees = true;
        QVERIFY(english(judgeRefits(spread)[0].message).starts_with("Quality factor: 50 refits"));
        QCOMPARE(*judgeRefits(spread)[0].value, 2.0);
    }

    void refitsThatAgree_orAreNone_sayNothing()
    {
        RefitCheck check = refits();
        check.values.resize(1);
        QVERIFY(judgeRefits(check).empty());
        QVERIFY(judgeRefits({}).empty());
    }

    void refitsThatFail_areACaution()
    {
        RefitCheck check = refits();
        check.failed = 3;
        const Findings found = judgeRefits(check);
        QCOMPARE(std::ssize(found), Index(1));
        QVERIFY(english(found[0].message).starts_with("3 of 50 records"));
    }

    /// A value that no draw has is the worst that can be said.
    void valueWithoutASpread_isNamed()
    {
        RefitCheck check = refits();
        check.values[0] = {"f0_hz", kUnknown, 1.0, kUnknown, false};
        QVERIFY(english(judgeRefits(check)[0].message).starts_with("Undamped natural frequency"));
    }

    void rows_areToldByTheirFrequency()
    {
        DrawnRow row;
        row.frequency_Hz = 2.5e6;
        row.withMagnitude = true;
        const DrawnValue one = value("", 300.0, 200.0);
        row.magnitude = one.drawn;
        row.gumMagnitude = one.gum;
        const DrawnRow first = row;
        row.withMagnitude = false;
        row.withPhase = true;
        row.phase.expanded = row.phase.leastExpanded = row.phase.mostExpanded = 0.02;
        row.gumPhase.u = 0.005;
        row.gumPhase.k = 2.0;
        const Findings found = judgeChain({}, {first}, {row});
        QCOMPARE(std::ssize(found), Index(1));
        const QString words = QString::fromStdString(english(found[0].message));
        QVERIFY2(words.startsWith(
                     "Phase of the frequency response at 2.5 MHz: Monte Carlo gives U = 1.1 °"),
            qPrintable(words));
        QVERIFY(words.contains("2 of 2"));
    }
};

DYNCAL_TEST(TestChainFindings)
#include "tst_chain_findings.moc"
