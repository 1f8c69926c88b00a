// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/step_levels.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

using namespace dyncal;

namespace {

constexpr auto N = ShotLevel::None, L = ShotLevel::Low, M = ShotLevel::Medium, H = ShotLevel::High;
using Levels = std::vector<ShotLevel>;

} // namespace

class TestStepLevels : public QObject
{
    Q_OBJECT

private slots:
    void threeHeights_inAnyOrder_areLowMediumHigh()
    {
        QVERIFY(levelsByStepHeight({5e5, 1e5, 3e5}) == (Levels{H, L, M}));
        QVERIFY(levelsByStepHeight({-5e5, 1e5, -3e5}) == (Levels{H, L, M})); // inverted sensors
    }

    void shotsOfTheSameHeight_shareTheirLevel()
    {
        QVERIFY(
            levelsByStepHeight({1.00, 2.05, 3.00, 1.02, 2.00, 3.1}) == (Levels{L, M, H, L, M, H}));
    }

    void moreThanThree_areSplitAtTheWidestGaps()
    {
        QVERIFY(levelsByStepHeight({1.0, 1.2, 4.0, 4.5, 20.0}) == (Levels{L, L, M, M, H}));
    }

    void twoHeights_areLowAndHigh()
    {
        QVERIFY(levelsByStepHeight({2.0, 1.0, 2.0}) == (Levels{H, L, H}));
    }

    void equalHeights_haveNoLevels()
    {
        QVERIFY(levelsByStepHeight({1.0, 1.05, 1.1}) == (Levels{N, N, N}));
        QVERIFY(levelsByStepHeight({1.0}) == Levels{N});
        QVERIFY(levelsByStepHeight({}).empty());
    }

    void shotsWithoutAStep_haveNone()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(levelsByStepHeight({std::nullopt, 1.0, nan, 2.0, 0.0}) == (Levels{N, L, N, H, N}));
    }
};

DYNCAL_TEST(TestStepLevels)
#include "tst_step_levels.moc"
