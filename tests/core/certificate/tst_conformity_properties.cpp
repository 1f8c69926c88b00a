// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What every statement of conformity must keep, whatever the response: no unit, no order of rows
// and no wider limit may turn it.

#include "core/certificate/conformity.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

using namespace dyncal;
using testing::isNear;
using enum dyncal::ConformityVerdict;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Rows at thirds of an octave whose deviations and u are drawn.
ResponseResult drawnResponse(std::mt19937_64 &random)
{
    std::normal_distribution<double> deviation(0.0, 0.02);
    std::uniform_real_distribution<double> u(0.001, 0.006), level(1.0, 3.0);
    constexpr Index kRows = 8;
    ResponseResult made;
    made.unit = made.sensitivityUnit = "V/Pa";
    made.sensitivity = level(random);
    made.fLow_Hz = 900.0;
    made.fHigh_Hz = 6e3;
    made.front = {1e-9, 1e-10};
    made.frequency_Hz = Eigen::VectorXd::NullaryExpr(
        kRows, [](Index i) { return 1000.0 * std::pow(10.0, 0.1 * static_cast<double>(i)); });
    made.magnitude = *made.sensitivity
        * Eigen::VectorXd::NullaryExpr(kRows, [&] { return 1.0 + deviation(random); });
    made.u_noiseMagnitude
        = *made.sensitivity * Eigen::VectorXd::NullaryExpr(kRows, [&] { return u(random); });
    made.u_magnitude = made.u_noiseMagnitude;
    made.boundEnd = made.boundAlias = made.u_frontMagnitude = Eigen::VectorXd::Zero(kRows);
    made.dof = Eigen::VectorXd::Constant(kRows, kInf);
    ShotSensitivity shot;
    shot.shot = 1;
    shot.uLevel_relative = 0.003;
    made.shots = {shot};
    return made;
}

DecisionSettings claim(DecisionRule rule, double within_percent, double risk_percent = 5.0)
{
    return {rule, within_percent, 1000.0, 1000.0 * std::pow(10.0, 0.7), risk_percent};
}

constexpr DecisionRule kRules[]{DecisionRule::Simple, DecisionRule::GuardBand, DecisionRule::Risk};

bool isConform(const ResponseResult &response, const DecisionSettings &decision)
{
    const ConformityResult judged = judgeConformity(response, decision);
    if (judged.verdict == NoStatement)
        qFatal("%s", english(judged.why).c_str());
    return judged.verdict == Conforms;
}

} // namespace

class TestConformityProperties : public QObject
{
    Q_OBJECT

private slots:
    /// A limit that is kept is kept by every wider one, and by a wider risk.
    void widerLimit_neverTurnsToRejection()
    {
        std::mt19937_64 random(1);
        for (int trial = 0; trial < 100; ++trial) {
            const ResponseResult response = drawnResponse(random);
            for (const DecisionRule rule : kRules) {
                bool before = false;
                for (const double within_percent : {1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0, 20.0}) {
                    const bool now = isConform(response, claim(rule, within_percent));
                    QVERIFY(now || !before);
                    before = now;
                }
            }
            bool before = false;
            for (const double risk_percent : {0.01, 1.0, 5.0, 20.0, 49.0}) {
                const bool now = isConform(response, claim(DecisionRule::Risk, 4.0, risk_percent));
                QVERIFY(now || !before);
                before = now;
            }
        }
    }

    /// What the guard band accepts lies beyond the limit with 2.5 % at most (to one side, k = 2),
    /// so that a risk of 2.5 % and simple acceptance accept it too.
    void guardBand_isStricterThanTheOthers()
    {
        std::mt19937_64 random(2);
        int accepted = 0;
        for (int trial = 0; trial < 300; ++trial) {
            const ResponseResult response = drawnResponse(random);
            if (!isConform(response, claim(DecisionRule::GuardBand, 4.0)))
                continue;
            ++accepted;
            QVERIFY(isConform(response, claim(DecisionRule::Simple, 4.0)));
            QVERIFY(isConform(response, claim(DecisionRule::Risk, 4.0, 2.5)));
        }
        QVERIFY(accepted > 10);
    }

    /// Another unit of the sensitivity is the same sensor.
    void unit_changesNothing()
    {
        std::mt19937_64 random(3);
        for (int trial = 0; trial < 50; ++trial) {
            const ResponseResult response = drawnResponse(random);
            ResponseResult other = response;
            for (Eigen::VectorXd *values :
                {&other.magnitude, &other.u_noiseMagnitude, &other.u_magnitude})
                *values *= 1e-6;
            other.sensitivity = -1e-6 * *response.sensitivity; // and the other polarity
            for (const DecisionRule rule : kRules) {
                const auto one = judgeConformity(response, claim(rule, 3.0));
                const auto two = judgeConformity(other, claim(rule, 3.0));
                QVERIFY(one.verdict == two.verdict);
                QCOMPARE(one.worst->frequency_Hz, two.worst->frequency_Hz);
                QVERIFY(std::abs(one.worst->deviation - two.worst->deviation) < 1e-12);
                QVERIFY(isNear(two.worst->u, one.worst->u, 1e-9));
            }
        }
    }

    /// Rows as they come, marked ones or not.
    void orderAndPlaceOfRows_changeNothing()
    {
        std::mt19937_64 random(4);
        for (int trial = 0; trial < 50; ++trial) {
            const ResponseResult response = drawnResponse(random);
            ResponseResult turned = response;
            for (Eigen::VectorXd *values : {&turned.frequency_Hz, &turned.magnitude,
                     &turned.u_noiseMagnitude, &turned.u_magnitude})
                values->reverseInPlace();
            ResponseResult marked = response;
            marked.atMarks = std::make_shared<ResponseResult>(response); // each row twice
            for (const DecisionRule rule : kRules) {
                const auto one = judgeConformity(response, claim(rule, 3.0));
                for (const ResponseResult *other : {&turned, &marked}) {
                    const auto two = judgeConformity(*other, claim(rule, 3.0));
                    QVERIFY(one.verdict == two.verdict);
                    QCOMPARE(one.worst->frequency_Hz, two.worst->frequency_Hz);
                }
                QCOMPARE(judgeConformity(marked, claim(rule, 3.0)).rows, 2 * one.rows);
            }
        }
    }

    /// The worst row decides: nothing else is rejected where it is accepted.
    void worstRow_isRejectedIfAnyIs()
    {
        std::mt19937_64 random(5);
        int rejected = 0;
        for (int trial = 0; trial < 300; ++trial) {
            const ResponseResult response = drawnResponse(random);
            for (const DecisionRule rule : kRules) {
                const auto judged = judgeConformity(response, claim(rule, 3.0));
                QCOMPARE(judged.worst->isAccepted, judged.verdict == Conforms);
                rejected += judged.verdict == Conforms ? 0 : 1;
            }
        }
        QVERIFY(rejected > 50);
    }

    /// The probability is that of draws: a quantity drawn about its deviation lies outside as
    /// often.
    void risk_isTheShareOfDraws()
    {
        std::mt19937_64 random(6);
        std::normal_distribution<double> normal;
        for (const auto &[d, u] : {std::pair(0.0, 0.03), {0.04, 0.01}, {-0.06, 0.02}}) {
            int outside = 0;
            constexpr int kDraws = 200000;
            for (int i = 0; i < kDraws; ++i)
                outside += std::abs(d + u * normal(random)) > 0.05 ? 1 : 0;
            const double p = probabilityOutside(d, u, kInf, 0.05);
            const double sd = std::sqrt(p * (1.0 - p) / kDraws);
            QVERIFY(std::abs(static_cast<double>(outside) / kDraws - p) < 4.0 * sd);
        }
    }

    /// Both signs alike; more u near the middle is more risk; from half to nothing across the
    /// limit.
    void risk_isEvenAndGrowsWithTheDeviation()
    {
        double before = 0.0;
        for (const double d : {0.0, 0.01, 0.02, 0.04, 0.05, 0.08}) {
            const double p = probabilityOutside(d, 0.01, 5.0, 0.05);
            QVERIFY(isNear(probabilityOutside(-d, 0.01, 5.0, 0.05), p, 1e-12));
            QVERIFY(p > before && p < 1.0);
            before = p;
        }
        QVERIFY(
            probabilityOutside(0.0, 0.02, kInf, 0.05) < probabilityOutside(0.0, 0.03, kInf, 0.05));
        // Fewer degrees of freedom have heavier tails.
        QVERIFY(
            probabilityOutside(0.0, 0.01, 2.0, 0.05) > probabilityOutside(0.0, 0.01, 20.0, 0.05));
    }

    /// Numbers that are none make no statement, and never one of conformity.
    void nonsense_isNoStatement()
    {
        std::mt19937_64 random(7);
        const ResponseResult good = drawnResponse(random);
        for (const double bad : {kUnknown, kInf, -kInf}) {
            for (const DecisionRule rule : kRules) {
                ResponseResult value = good, noise = good;
                value.magnitude[3] = bad;
                noise.u_noiseMagnitude[3] = bad;
                for (const ResponseResult *response : {&value, &noise})
                    QVERIFY(judgeConformity(*response, claim(rule, 50.0)).verdict == NoStatement);
            }
        }
    }
};

DYNCAL_TEST(TestConformityProperties)
#include "tst_conformity_properties.moc"
