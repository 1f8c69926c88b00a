// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the chain adds where it is stated, and where it is not.

#include "core/uncertainty/chain_effects.h"
#include "core/uncertainty/reported_value.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace dyncal;

class TestChainEffects : public QObject
{
    Q_OBJECT

private slots:
    void unstated_isARangeAndNotZero()
    {
        const ChainEffects effects = chainEffects({});
        QCOMPARE(std::ssize(effects.ofSensitivity), Index(3));
        for (const UncertaintyLine &line : effects.ofSensitivity)
            QVERIFY(line.u > 0.0 && std::abs(line.contribution) == line.u);
        QVERIFY(effects.ofSensitivity[0].contribution < 0.0); // S is divided by the gain
        QVERIFY(std::abs(effects.ofSensitivity[0].u - 0.005 / std::sqrt(3.0)) < 1e-15);
        QVERIFY(std::abs(effects.clock.u - 50e-6 / std::sqrt(3.0)) < 1e-18);
    }

    void stated_wins()
    {
        const ChainEffects effects
            = chainEffects({{"gain_relative", 0.002, Distribution::Normal, 9.0},
                {"clock_relative", 0.0, Distribution::Normal, {}}, {"t1_k", 5.0, {}, {}}});
        QCOMPARE(effects.ofSensitivity[0].quantity, std::string("gain_relative"));
        QCOMPARE(effects.ofSensitivity[0].u, 0.002);
        QCOMPARE(effects.ofSensitivity[0].dof, 9.0);
        QCOMPARE(effects.clock.u, 0.0);
        QVERIFY(effects.ofSensitivity[1].u > 0.0);
    }

    /// The root mean square of 1/sinc(f T) - 1, T drawn from its range, as far as g T^2 describes
    /// it.
    void unknownFront_isTheMeanSquareOfWhatIsMissing()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> duration(0.0, kUnstatedFront_s);
        for (const double f_Hz : {1e4, 1e5, 1e6, 2e6}) {
            double squares = 0.0;
            constexpr int kDraws = 20000;
            for (int i = 0; i < kDraws; ++i) {
                const double x = 3.14159265358979 * f_Hz * duration(random);
                squares += std::pow(x / std::sin(x) - 1.0, 2) / kDraws;
            }
            const double u = frontLine(f_Hz).u;
            QVERIFY2(std::abs(u / std::sqrt(squares) - 1.0) < 0.03,
                qPrintable(QString::number(u / std::sqrt(squares))));
        }
        QCOMPARE(frontLine(0.0).u, 0.0);
        QCOMPARE(frontLine(1e9).u, frontLine(9e6).u); // nothing is known there
        QVERIFY(frontLine(1e9).u > 3.6);
        QVERIFY(std::abs(frontLine(5e6).u - (0.5 * M_PI - 1.0) / std::sqrt(5.0)) < 1e-12);
    }

    void combined_hasSharesOfItsVariance()
    {
        ReportedValue value{
            "f0_hz", 1e5, "Hz", {directLine("noise", 3.0, 4.0), directLine("x", 4.0)}};
        combineLines(value);
        QCOMPARE(*value.u, 5.0);
        QVERIFY(std::abs(value.sharePercent(value.lines[0]) - 36.0) < 1e-12);
        QVERIFY(std::abs(value.dof - 625.0 / 81.0 * 4.0) < 1e-12);
        QVERIFY(std::abs(value.k - coverageFactor(value.dof, 0.95)) < 1e-12);
    }
};

DYNCAL_TEST(TestChainEffects)
#include "tst_chain_effects.moc"
