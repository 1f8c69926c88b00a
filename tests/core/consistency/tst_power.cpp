// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_random.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <map>
#include <string>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr int kDraws = 200;

/// A shot whose velocity is typed has every comparison but that of a typed step and the driver's.
const MadeShot kShot{.typedVelocity_m_s = kMadeVelocity_m_s};

struct Found
{
    int tried = 0;
    int caught = 0;
};

std::string nameOf(const WayComparison &check)
{
    return std::string(comparedName(check.of)) + ", " + wayName(check.a) + ' ' + check.channel;
}

/// How often each comparison contradicts, all inputs drawn from their u and one way wrong by
/// `size` combined u.
std::map<std::string, Found> caughtOf(double size)
{
    const MadeComparison made({kShot});
    const ShotWays &ways = *made.ways[0];
    std::map<std::string, Found> found;
    for (int draw = 0; draw < kDraws; ++draw) {
        RandomStream random(20261125, draw, 11);
        Eigen::VectorXd x(std::ssize(ways.inputs()));
        for (Index i = 0; i < x.size(); ++i) {
            const UncertainInput &input = ways.inputs()[static_cast<std::size_t>(i)];
            x[i] = input.value + input.u * random.nextNormal();
        }
        const Eigen::VectorXd values = ways.values(ways.at(x)).value();
        for (std::size_t i = 0; i < ways.made().size(); ++i) {
            WayComparison check = made.compared->comparisons()[i];
            if (!check.isMade())
                continue;
            const auto at = static_cast<Index>(2 * i);
            check.value_a = values[at] + (draw % 2 == 0 ? size : -size) * check.u;
            check.value_b = values[at + 1];
            Found &counted = found[nameOf(check)];
            ++counted.tried;
            counted.caught += check.agrees() ? 0 : 1;
        }
    }
    return found;
}

double percentOf(const std::map<std::string, Found> &found)
{
    Found all;
    for (const auto &[name, one] : found) {
        all.tried += one.tried;
        all.caught += one.caught;
    }
    return 100.0 * all.caught / all.tried;
}

} // namespace

/// 200 draws of every comparison, seeds 20261125, stream 11. A fault of 5 u is beyond 3.6 u in
/// 91.9 % of draws (normal distribution), one of 0.5 u in 0.1 %.
class TestPower : public QObject
{
    Q_OBJECT

private slots:
    void faultOfFiveU_isCaughtInNineOfTen()
    {
        const auto found = caughtOf(5.0);
        QVERIFY(found.size() >= 10);
        for (const auto &[name, one] : found) {
            qInfo("%s: %d of %d", name.c_str(), one.caught, one.tried);
            QVERIFY2(one.caught >= 180, name.c_str());
        }
        QVERIFY(std::abs(percentOf(found) - 91.9) < 3.0);
    }

    void faultOfHalfU_isLeftAlone()
    {
        for (const auto &[name, one] : caughtOf(0.5))
            QVERIFY2(one.caught <= 4, name.c_str());
    }

    void nothingWrong_isLeftAlone()
    {
        for (const auto &[name, one] : caughtOf(0.0))
            QVERIFY2(one.caught <= 2, name.c_str());
    }
};

DYNCAL_TEST(TestPower)
#include "tst_power.moc"
