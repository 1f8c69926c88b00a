// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The sentences that say why an order is suggested, from evidence written down: every number in
// them must be the one that the evidence holds.

#include "core/realization/order/order_spread.h"
#include "core/realization/order/order_words.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

namespace {

/// Ten singular values, two above the floor; order 2 of one pole pair, stable up to order 4.
struct Scene
{
    HankelDecomposition decomposition;
    OrderSuggestion suggestion;
    OrderEvidence evidence;

    Scene()
    {
        decomposition.rows = 50;
        decomposition.singularValues.resize(10);
        decomposition.singularValues << 900.0, 840.0, 42.0, 41.0, 40.0, 39.0, 38.0, 37.0, 36.0,
            35.0;
        decomposition.noiseFloor_p95 = 55.0;
        decomposition.leftVectors = Eigen::MatrixXd::Identity(50, 10);
        decomposition.shiftGram = Eigen::MatrixXd::Zero(10, 10);
        suggestion.order = 2;
        suggestion.reason = {"The reason of the suggestion.", {}};
        evidence.poles = {{2, 1000.0, 0.100, PoleStability::New, true, 50.0},
            {3, 1010.0, 0.104, PoleStability::FrequencyAndDamping, true, 50.0},
            {4, 990.0, 0.096, PoleStability::FrequencyAndDamping, true, 50.0}};
        evidence.fit_percent = Eigen::Vector4d(40.0, 88.04, 88.2, 88.3);
        evidence.fitAttainable_percent = 88.96;
        evidence.unstable = {0, 0, 0, 0};
        evidence.nyquist = {0, 0, 0, 0};
        evidence.crossShot_percent = Eigen::Vector4d(60.0, 12.0, 13.0, 14.0);
    }

    std::vector<std::string> words() const
    {
        std::vector<std::string> list;
        for (const Message &word : wordsFor(decomposition, suggestion, evidence))
            list.push_back(english(word));
        return list;
    }
};

std::string with(const std::vector<std::string> &words, const std::string &part)
{
    const auto found = std::find_if(words.begin(), words.end(),
        [&](const std::string &word) { return word.find(part) != std::string::npos; });
    return found == words.end() ? std::string() : *found;
}

} // namespace

class TestOrderWords : public QObject
{
    Q_OBJECT

private slots:
    void numbers_areThoseOfTheEvidence()
    {
        const std::vector<std::string> words = Scene().words();
        QCOMPARE(words.front(), std::string("The reason of the suggestion."));
        QCOMPARE(with(words, "Singular value"),
            std::string("Singular value 2 is 20 times the next one; above the noise floor lie 2."));
        // Mean 1000 Hz, half of 990..1010; mean 0.1, half of 0.096..0.104.
        QCOMPARE(with(words, "pole at"),
            std::string(
                "The pole at 1.000 kHz \xC2\xB1 0.010 kHz with damping ratio 0.1000 \xC2\xB1 0.0040 is stable from order 2 to 4; the ranges are those over these orders."));
        QCOMPARE(with(words, "Poles of the other shots"),
            std::string(
                "Poles of the other shots describe a shot best at order 2: they leave 12 % of it."));
        // 0.98 times 88.96 is 87.18, which order 2 reaches.
        QCOMPARE(with(words, "98 %"),
            std::string(
                "Order 2 is the lowest whose FIT (88 %) reaches 98 % of the attainable 89 % with neither an unstable nor a Nyquist pole."));
    }

    void leastOfTheOtherShots_isNamedWhereItLiesElsewhere()
    {
        Scene scene;
        scene.evidence.crossShot_percent = Eigen::Vector4d(60.0, 12.0, kUnknown, 11.5);
        QCOMPARE(with(scene.words(), "Poles of the other shots"),
            std::string(
                "Poles of the other shots leave 12 % of a shot at order 2; the least, 11.5 %, at order 4."));
        scene.evidence.crossShot_percent[1] = kUnknown; // diverges at the order itself
        QVERIFY(with(scene.words(), "Poles of the other shots").empty());
        scene.evidence.crossShot_percent = Eigen::VectorXd(1); // the order was not looked at
        QVERIFY(with(scene.words(), "Poles of the other shots").empty());
    }

    void noOrderThatSuffices_isSaidWithWhatWasTried()
    {
        Scene scene;
        scene.evidence.nyquist = {1, 1, 1, 1};
        QCOMPARE(with(scene.words(), "No order"),
            std::string(
                "No order up to 4 reaches 98 % of the attainable FIT of 89 % with neither an unstable nor a Nyquist pole."));
        for (const double nothing : {kUnknown, 10.0, -20.0}) {
            scene.evidence.fitAttainable_percent = nothing;
            QVERIFY(with(scene.words(), "attainable").empty());
        }
    }

    void polesThatComeAndGo_areNotCalledStable()
    {
        Scene scene;
        scene.evidence.poles.resize(1); // no neighbour keeps it
        QVERIFY(with(scene.words(), "pole at").empty());
        scene = Scene();
        scene.evidence.poles[0].standsOut = false; // of the order itself, in the noise
        QVERIFY(with(scene.words(), "pole at").empty());
    }

    void manyPoles_threeAreNamed()
    {
        Scene scene;
        scene.evidence.poles.clear();
        for (Index order = 2; order <= 3; ++order) {
            for (int i = 1; i <= 5; ++i)
                scene.evidence.poles.push_back({order, 1000.0 * i, 0.1,
                    order == 2 ? PoleStability::New : PoleStability::FrequencyAndDamping, true,
                    50.0});
        }
        const std::vector<std::string> words = scene.words();
        const auto named = std::count_if(words.begin(), words.end(),
            [](const std::string &word) { return word.find("pole at") != std::string::npos; });
        QCOMPARE(named, std::ptrdiff_t(3));
    }

    void lastSingularValue_hasNoNextOne()
    {
        Scene scene;
        scene.suggestion.order = 10;
        QCOMPARE(with(scene.words(), "Singular value"),
            std::string("Singular values above the noise floor: 2."));
        scene.suggestion.order = 2;
        scene.decomposition.singularValues.tail(8).setZero(); // noise-free: the next one is 0
        QCOMPARE(with(scene.words(), "Singular value"),
            std::string("Singular values above the noise floor: 2."));
    }

    void unitOfTheRecords_isInNoSentence()
    {
        Scene scene;
        const std::vector<std::string> before = scene.words();
        scene.decomposition.singularValues *= 1e-7;
        scene.decomposition.noiseFloor_p95 *= 1e-7;
        QVERIFY(scene.words() == before);
    }

    void undampedPole_readsAsOne()
    {
        Scene scene;
        for (OrderPole &pole : scene.evidence.poles)
            pole.dampingRatio = 0.0;
        for (const std::string &word : scene.words())
            QVERIFY2(word.find("nan") == std::string::npos && word.find("inf") == std::string::npos,
                word.c_str());
        QVERIFY(!with(scene.words(), "pole at").empty());
    }

    void spreadOfAPole_isTheSameFromAnyOrderOfItsChain()
    {
        const Scene scene;
        const OrderSpread first = spreadAround(scene.evidence, 2, 1000.0).value();
        for (const OrderPole &pole : scene.evidence.poles) {
            const OrderSpread other
                = spreadAround(scene.evidence, pole.order, pole.frequency_Hz).value();
            QCOMPARE(other.fromOrder, first.fromOrder);
            QCOMPARE(other.toOrder, first.toOrder);
            QCOMPARE(other.frequency_Hz, first.frequency_Hz);
            QCOMPARE(other.dampingSpread, first.dampingSpread);
        }
        // 10 % is the limit of what is meant.
        QVERIFY(spreadAround(scene.evidence, 2, 1100.0));
        QVERIFY(!spreadAround(scene.evidence, 2, 1120.0));
    }
};

DYNCAL_TEST(TestOrderWords)
#include "tst_order_words.moc"
