// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// MOD-007 and the spread of a pole, from evidence that is written down.

#include "core/realization/order/order_findings.h"
#include "core/realization/order/order_spread.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

/// A model of order 2 whose shots 4, 1 and 7 have FITs of 90, 80 and 70 %.
SensorModel threeShots()
{
    SensorModel model;
    model.order = 2;
    for (const auto &[shot, fit_percent] : {std::pair(4, 90.0), {1, 80.0}, {7, 70.0}}) {
        SeriesFit series;
        series.shot = shot;
        series.fit_percent = fit_percent;
        model.series.push_back(series);
    }
    return model;
}

/// By the poles of the others; the columns in another order than the model's series.
OrderEvidence evidence(double ofShot1, double ofShot4, double ofShot7)
{
    OrderEvidence made;
    made.crossShots = {1, 4, 7};
    made.crossShotFit_percent.resize(3, 3);
    made.crossShotFit_percent << -500.0, -500.0, -500.0, ofShot1, ofShot4, ofShot7, -500.0, -500.0,
        -500.0;
    return made;
}

OrderPole pole(Index order, double frequency_Hz, double damping,
    PoleStability stability = PoleStability::FrequencyAndDamping)
{
    OrderPole made;
    made.order = order;
    made.frequency_Hz = frequency_Hz;
    made.dampingRatio = damping;
    made.stability = stability;
    return made;
}

OrderEvidence polesOnly(std::vector<OrderPole> poles)
{
    OrderEvidence made;
    made.poles = std::move(poles);
    return made;
}

} // namespace

class TestOrderFindings : public QObject
{
    Q_OBJECT

private slots:
    /// Of its own column and of the model's order, more than 15 points below its own FIT.
    void shotBelowItsOwnFit_isNamed()
    {
        const Findings findings = judgeOtherShots(threeShots(), evidence(64.9, 75.1, 54.0));
        QCOMPARE(findings.size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            const Finding &one = findings[i];
            QCOMPARE(one.id, std::string("MOD-007"));
            QVERIFY(one.severity == Severity::Caution);
            QCOMPARE(one.shot, Index(i == 0 ? 1 : 7));
            QVERIFY(isNear(one.value.value_or(0.0), i == 0 ? 15.1 : 16.0));
            QCOMPARE(one.limit.value_or(0.0), 15.0);
        }
        const std::string said = english(findings[0].message);
        QVERIFY2(said.starts_with("Shot 1:"), said.c_str());
        QVERIFY2(said.find("80") != said.npos && said.find("64.9") != said.npos, said.c_str());
    }

    /// Exactly at the limit, and better than their own, nothing is said.
    void limit_isNotBeyondIt()
    {
        QVERIFY(judgeOtherShots(threeShots(), evidence(65.0, 75.0, 55.0)).empty());
        QVERIFY(judgeOtherShots(threeShots(), evidence(99.0, 99.0, 99.0)).empty());
        QVERIFY(judgeOtherShots(threeShots(), evidence(kUnknown, kUnknown, kUnknown)).empty());
    }

    /// Nothing to compare: a model that diverges, an order that was not tried, other shots.
    void withoutACounterpart_nothingIsSaid()
    {
        const OrderEvidence far = evidence(0.0, 0.0, 0.0);
        SensorModel model = threeShots();
        QCOMPARE(judgeOtherShots(model, far).size(), std::size_t(3));
        model.diverges = true;
        QVERIFY(judgeOtherShots(model, far).empty());
        model = threeShots();
        model.order = 4;
        QVERIFY(judgeOtherShots(model, far).empty());
        model = threeShots();
        model.series.erase(model.series.begin());
        QCOMPARE(judgeOtherShots(model, far).size(), std::size_t(2));
        QVERIFY(judgeOtherShots(threeShots(), {}).empty());
    }

    /// The nearest pole of the order within 10 %, and none beyond.
    void spread_startsAtTheNearestPole()
    {
        const OrderEvidence made = polesOnly(
            {pole(2, 100e3, 0.05, PoleStability::New), pole(2, 104e3, 0.2, PoleStability::New)});
        QCOMPARE(spreadAround(made, 2, 101e3)->frequency_Hz, 100e3);
        QCOMPARE(spreadAround(made, 2, 103e3)->frequency_Hz, 104e3);
        QVERIFY(spreadAround(made, 2, 94.7e3).has_value()); // 104 is 9.8 %, 100 is 5.6 % away
        QVERIFY(!spreadAround(made, 2, 90.8e3));
        QVERIFY(spreadAround(made, 2, 91e3).has_value());
        QVERIFY(!spreadAround(made, 3, 100e3));
        QVERIFY(!spreadAround({}, 2, 100e3));
        QVERIFY(!spreadAround(made, 2, kUnknown));
    }

    /// Alone it has no spread.
    void onePole_hasNoRange()
    {
        const auto alone
            = spreadAround(polesOnly({pole(4, 1e5, 0.05, PoleStability::New)}), 4, 1e5);
        QVERIFY(alone && alone->fromOrder == 4 && alone->toOrder == 4);
        QCOMPARE(alone->frequencySpread_Hz, 0.0);
        QCOMPARE(alone->dampingSpread, 0.0);
    }

    /// From wherever in a chain one asks: the same orders, means and ranges.
    void chain_isTheSameFromEveryLink()
    {
        std::vector<OrderPole> poles{pole(2, 100.0e3, 0.050, PoleStability::New)};
        double frequencies = 100.0e3, dampings = 0.050;
        for (Index order = 3; order <= 8; ++order) {
            const double turn = order % 2 == 0 ? 1.0 : -1.0;
            poles.push_back(pole(order, 100.0e3 + turn * 50.0 * static_cast<double>(order),
                0.050 + turn * 1e-4 * static_cast<double>(order)));
            frequencies += poles.back().frequency_Hz;
            dampings += poles.back().dampingRatio;
        }
        poles.push_back(pole(9, 100e3, 0.05, PoleStability::Frequency)); // the chain ends before
        for (Index order = 2; order <= 8; ++order) {
            const auto spread = spreadAround(polesOnly(poles), order, 100e3);
            QVERIFY(spread.has_value());
            QCOMPARE(spread->fromOrder, Index(2));
            QCOMPARE(spread->toOrder, Index(8));
            QVERIFY(isNear(spread->frequency_Hz, frequencies / 7.0));
            QVERIFY(isNear(spread->dampingRatio, dampings / 7.0));
            QVERIFY(isNear(spread->frequencySpread_Hz, 0.5 * (400.0 + 350.0)));
            QVERIFY(isNear(spread->dampingSpread, 0.5 * (8e-4 + 7e-4)));
        }
    }

    /// A pole that grows is no link, though it lies nearer.
    void unstablePole_isNoLink()
    {
        const OrderEvidence made = polesOnly({pole(2, 100e3, 0.05, PoleStability::New),
            pole(3, 100e3, -0.01, PoleStability::Unstable), pole(3, 101e3, 0.05)});
        const auto spread = spreadAround(made, 2, 100e3);
        QVERIFY(spread && spread->toOrder == 3);
        QVERIFY(isNear(spread->frequency_Hz, 100.5e3));
        QVERIFY(!spreadAround(polesOnly({pole(3, 100e3, -0.01, PoleStability::Unstable)}), 3, 1e5));
    }

    void names_areDifferentWords()
    {
        using enum PoleStability;
        QCOMPARE(std::string(poleStabilityName(New)), std::string("new"));
        QCOMPARE(std::string(poleStabilityName(Frequency)), std::string("frequency"));
        QVERIFY(
            std::string(poleStabilityName(FrequencyAndDamping)) != poleStabilityName(Frequency));
        QVERIFY(std::string(poleStabilityName(Unstable)) != poleStabilityName(New));
    }
};

DYNCAL_TEST(TestOrderFindings)
#include "tst_order_findings.moc"
