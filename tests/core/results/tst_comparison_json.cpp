// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Orders beside each other, from models written down: what each says, and why it does not.

#include "core/results/comparison_json.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

using namespace dyncal;
using Json = nlohmann::json;

namespace {

ComparedOrder exampleOrder()
{
    static const CalibrationResults results = example::calibration();
    ComparedOrder one;
    one.order = 2;
    one.model = results.model;
    one.assessment = results.assessment;
    one.response = results.response;
    one.whiteness_p = 0.25;
    one.bic = -1234.5;
    one.note = "the pair alone";
    return one;
}

/// The example's order 2 with its model changed.
template <typename Change>
ComparedOrder changed(Change change)
{
    ComparedOrder one = exampleOrder();
    SensorModel model = *one.model;
    change(model);
    ModelAssessment assessment = *one.assessment;
    assessment.poles = model.poles;
    one.model = std::make_shared<const SensorModel>(model);
    one.assessment = std::make_shared<const ModelAssessment>(assessment);
    return one;
}

ComparedOrder failed()
{
    ComparedOrder one;
    one.order = 77;
    one.error = Error{ErrorKind::Usage, {"Order %1 is too large.", {"77"}}, {}, 0};
    return one;
}

Json written(const std::vector<ComparedOrder> &orders, const OrderSuggestion &suggestion)
{
    CalibrationResults results;
    DecompositionResult decomposition;
    decomposition.suggestion = suggestion;
    results.decomposition = std::make_shared<const DecompositionResult>(decomposition);
    return Json::parse(comparisonJson(results, orders));
}

Json orderOf(const ComparedOrder &order)
{
    return written({order}, {2, {"Smallest BIC.", {}}, {}})["orders"][0];
}

std::set<std::string> keysOf(const Json &object)
{
    std::set<std::string> keys;
    for (const auto &[key, value] : object.items()) {
        if (!key.ends_with("_reason"))
            keys.insert(key);
    }
    return keys;
}

bool everyNullHasAReason(const Json &object)
{
    for (const auto &[key, value] : object.items()) {
        if (value.is_null() && object.value(key + "_reason", "").size() < 6)
            return false;
        if (key.ends_with("_reason") && !object[key.substr(0, key.size() - 7)].is_null())
            return false; // a reason for what is there
    }
    return true;
}

} // namespace

class TestComparisonJson : public QObject
{
    Q_OBJECT

private slots:
    void whole_saysWhatTheModelHolds()
    {
        const Json order = orderOf(exampleOrder());
        QCOMPARE(order["order"], Json(2));
        QCOMPARE(order["note"], Json("the pair alone"));
        QCOMPARE(order["bic"], Json(-1234.5));
        QCOMPARE(order["frequency_hz"], Json(example::kF0_Hz));
        QCOMPARE(order["damping_ratio"], Json(example::kZeta));
        QCOMPARE(order["u_frequency_hz"], Json(412.0));
        QCOMPARE(order["sensitivity"], Json(example::kSensitivity_V_Pa));
        QCOMPARE(order["whiteness_p"], Json(0.25));
        QCOMPARE(order["diverges"], Json(false));
        QVERIFY(everyNullHasAReason(order));
    }

    void everyOrder_hasTheSameKeys()
    {
        // A script reads the columns of a table, whatever became of an order.
        const std::set<std::string> keys = keysOf(orderOf(exampleOrder()));
        QCOMPARE(keysOf(orderOf(failed())), keys);
        QCOMPARE(keysOf(orderOf(changed([](SensorModel &model) { model.diverges = true; }))), keys);
        QCOMPARE(keysOf(orderOf(changed([](SensorModel &model) { model.poles.clear(); }))), keys);
    }

    void failedOrder_saysWhyInEveryPlace()
    {
        const Json order = orderOf(failed());
        for (const char *key : {"fit_percent", "frequency_hz", "unstable_poles", "sensitivity"}) {
            QVERIFY2(order[key].is_null(), key);
            QCOMPARE(order[std::string(key) + "_reason"], Json("Order 77 is too large."));
        }
        QCOMPARE(order["findings"], Json::array());
        QVERIFY(everyNullHasAReason(order));
    }

    void divergingOrder_hasNoNumberOfItsRunaway()
    {
        ComparedOrder one = changed([](SensorModel &model) {
            model.diverges = true;
            model.fit_percent = -1e300;
            model.poles[0].poleClass = model.poles[1].poleClass = PoleClass::Unstable;
        });
        one.response = nullptr;
        one.whiteness_p = kUnknown;
        const Json order = orderOf(one);
        for (const char *key : {"fit_percent", "frequency_hz", "u_damping_ratio", "sensitivity"})
            QVERIFY2(order[key].is_null(), key);
        QCOMPARE(order["unstable_poles"], Json(2));
        QVERIFY(everyNullHasAReason(order));
    }

    void modelWithoutResonance_orUncertainty_saysSo()
    {
        const Json still = orderOf(changed([](SensorModel &model) { model.poles.clear(); }));
        QVERIFY(still["frequency_hz"].is_null() && everyNullHasAReason(still));
        QVERIFY(!still["fit_percent"].is_null());
        const Json raw = orderOf(changed([](SensorModel &model) {
            for (Pole &pole : model.poles)
                pole.u_frequency_Hz = pole.u_dampingRatio = kUnknown;
        }));
        QCOMPARE(raw["frequency_hz"], Json(example::kF0_Hz));
        QVERIFY(raw["u_frequency_hz"].is_null() && everyNullHasAReason(raw));
        QVERIFY(raw["u_frequency_hz_reason"] != still["u_frequency_hz_reason"]);
    }

    void poles_areCountedByClass()
    {
        SensorModel model;
        model.poles.resize(7);
        model.poles[1].poleClass = model.poles[5].poleClass = PoleClass::Nyquist;
        model.poles[2].poleClass = PoleClass::Unstable;
        QCOMPARE(countPoles(model, PoleClass::Nyquist), Index(2));
        QCOMPARE(countPoles(model, PoleClass::Unstable), Index(1));
        QCOMPARE(countPoles(model, PoleClass::Other), Index(4));
        QCOMPARE(countPoles({}, PoleClass::Sensor), Index(0));
    }

    void noSuggestion_isNullWithItsReason()
    {
        const Json root = written({}, {0, {"Too %1 samples.", {"few"}}, {}});
        QVERIFY(root["suggested_order"].is_null());
        QCOMPARE(root["suggested_order_reason"], Json("Too few samples."));
        QCOMPARE(root["orders"], Json::array());
        QCOMPARE(written({}, {4, {"BIC.", {}}, {}})["suggested_order"], Json(4));
    }

    void orders_stayInTheOrderAsked()
    {
        ComparedOrder high = exampleOrder();
        high.order = 100;
        const Json root = written({high, failed(), exampleOrder()}, {2, {"BIC.", {}}, {}});
        QCOMPARE(root["schema"], Json("dyncal-compare/1"));
        QCOMPARE(root["orders"][0]["order"], Json(100));
        QCOMPARE(root["orders"][1]["order"], Json(77));
        QCOMPARE(root["orders"][2]["order"], Json(2));
    }
};

DYNCAL_TEST(TestComparisonJson)
#include "tst_comparison_json.moc"
