// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Lines of a budget and what they make together: GUM 5.1.2 and G.4.1, with the example of GUM H.1.

#include "core/base/uncertain_value.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

class TestUncertainValue : public QObject
{
    Q_OBJECT

private slots:
    void lines_addAsSquares()
    {
        const CombinedUncertainty all = combined({directLine("a", 3.0), directLine("b", -4.0)});
        QCOMPARE(all.u, 5.0);
        QVERIFY(std::isinf(all.dof));
        QCOMPARE(combined({}).u, 0.0);
        QVERIFY(std::isinf(combined({}).dof));
    }

    /// GUM H.1.6: u(l) = 32 nm of 25 (18 dof), 9.7 (25.6), 2.9 (50), 16.6 (2): 16 degrees of
    /// freedom.
    void degreesOfFreedom_areThoseOfWelchAndSatterthwaite()
    {
        const CombinedUncertainty all
            = combined({directLine("l_S", 25.0, 18.0), directLine("d", 9.7, 25.6),
                directLine("delta_alpha", 2.9, 50.0), directLine("delta_theta", 16.6, 2.0)});
        QCOMPARE(std::round(all.u), 32.0);
        QCOMPARE(std::floor(all.dof), 16.0);
    }

    void scaling_movesContributionAndSensitivity_notTheSource()
    {
        const auto lines = scaled({directLine("a", 0.02, 7.0, Distribution::Rectangular)}, -5.0);
        QCOMPARE(lines[0].u, 0.02);
        QCOMPARE(lines[0].dof, 7.0);
        QCOMPARE(lines[0].contribution, -0.1);
        QCOMPARE(lines[0].sensitivity, -5.0);
        QCOMPARE(lines[0].distribution, Distribution::Rectangular);
    }
};

DYNCAL_TEST(TestUncertainValue)
#include "tst_uncertain_value.moc"
