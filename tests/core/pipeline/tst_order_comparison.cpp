// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/order_comparison.h"
#include "tests/support/test_program.h"

#include "core/realization/hankel/realized_poles.h"
#include "core/results/comparison_json.h"
#include "core/results/results_json.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

std::shared_ptr<const CaptureSet> simulated(double noise = 0.01)
{
    SimulationSettings settings;
    settings.sensor = *sensorPreset("optic3");
    settings.duration_s = 0.004;
    settings.noise = noise;
    return std::make_shared<const CaptureSet>(simulateShots(settings)->set);
}

/// Three shots computed up to their end, once for all tests.
const CalibrationResults &calibrated()
{
    static const CalibrationResults results = [] {
        ResultCache cache;
        return runPipeline(simulated(), {}, cache, StageId::Evidence).results;
    }();
    return results;
}

QJsonObject jsonOf(const std::vector<ComparedOrder> &orders)
{
    const std::string json = comparisonJson(calibrated(), orders);
    return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
}

/// Every null of an object has its reason beside it.
bool isExplained(const QJsonObject &object)
{
    for (auto it = object.begin(); it != object.end(); ++it) {
        if (it->isNull() && object[it.key() + "_reason"].toString().size() < 5)
            return false;
    }
    return true;
}

void compareModels(const ComparedOrder &compared, const CalibrationResults &run)
{
    const SensorModel &a = *compared.model;
    const SensorModel &b = *run.model;
    QCOMPARE(a.order, b.order);
    QCOMPARE(a.fit_percent, b.fit_percent); // to the last bit
    QCOMPARE(a.plateauGain, b.plateauGain);
    QCOMPARE(a.poles.size(), b.poles.size());
    for (std::size_t i = 0; i < a.poles.size(); ++i) {
        QVERIFY(a.poles[i].z == b.poles[i].z);
        QVERIFY(a.poles[i].frequency_Hz == b.poles[i].frequency_Hz);
    }
    const std::vector<Pole> &known = compared.assessment->poles;
    QCOMPARE(known.size(), run.assessment->poles.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double u_Hz = run.assessment->poles[i].u_frequency_Hz;
        QVERIFY(known[i].u_frequency_Hz == u_Hz
            || (std::isnan(known[i].u_frequency_Hz) && std::isnan(u_Hz)));
    }
    QVERIFY(a.stateSpace.A == b.stateSpace.A);
}

} // namespace

class TestOrderComparison : public QObject
{
    Q_OBJECT

private slots:
    void eachOrder_isThatOfARunOfItsOwn()
    {
        const auto compared = compareOrders(calibrated(), {}, {2, 3, 8, 50});
        QVERIFY(compared.has_value());
        QCOMPARE(compared->size(), std::size_t(4));
        for (const ComparedOrder &one : *compared) {
            Recipe recipe;
            recipe.realization.order = one.order;
            ResultCache cache;
            const CalibrationResults run
                = runPipeline(simulated(), recipe, cache, StageId::Evidence).results;
            QVERIFY(one.model && one.assessment && one.response && !one.error);
            compareModels(one, run);
            QVERIFY(one.response->sensitivity == run.response->sensitivity);
            QVERIFY(one.response->modelMagnitude == run.response->modelMagnitude);
        }
    }

    void orderOfTheRun_isNotComputedAgain()
    {
        const Index order = calibrated().model->order;
        const auto compared = compareOrders(calibrated(), {}, {order});
        QCOMPARE(compared->front().model, calibrated().model);
        QCOMPARE(compared->front().assessment, calibrated().assessment);
        QCOMPARE(compared->front().response, calibrated().response);
    }

    void whiteness_tellsAGoodOrderFromABadOne()
    {
        const auto compared = compareOrders(calibrated(), {}, {1, 2});
        QVERIFY(compared->at(0).whiteness_p < 1e-6);
        QVERIFY2(compared->at(1).whiteness_p > 1e-3,
            qPrintable(QString::number(compared->at(1).whiteness_p)));
        QVERIFY(*compared->at(0).bic > *compared->at(1).bic);
    }

    void impossibleOrder_hasItsReasonInItsPlace()
    {
        const auto compared = compareOrders(calibrated(), {}, {2, 1900, 0});
        QVERIFY(compared->at(0).model);
        for (const std::size_t i : {std::size_t(1), std::size_t(2)}) {
            QVERIFY(!compared->at(i).model && compared->at(i).error);
            QVERIFY(compared->at(i).error->kind == ErrorKind::Usage);
            QVERIFY(std::isnan(compared->at(i).whiteness_p));
        }
        const QJsonObject bad = jsonOf(*compared)["orders"][1].toObject();
        QVERIFY(bad["fit_percent"].isNull());
        QVERIFY(bad["fit_percent_reason"].toString().contains("1900"));
        QVERIFY(isExplained(bad));
    }

    void divergingOrder_hasNoNumbers()
    {
        ComparedOrder diverging;
        diverging.order = 100;
        SensorModel model = *calibrated().model;
        model.diverges = true;
        model.fit_percent = -1e53;
        diverging.model = std::make_shared<const SensorModel>(model);
        const QJsonObject json = jsonOf({diverging})["orders"][0].toObject();
        QVERIFY(json["diverges"].toBool());
        for (const char *key :
            {"fit_percent", "frequency_hz", "damping_ratio", "whiteness_p", "sensitivity"})
            QVERIFY2(json[QLatin1String(key)].isNull(), key);
        QVERIFY(isExplained(json));
    }

    void json_holdsWhatTheModelsHold()
    {
        const auto compared = compareOrders(calibrated(), {}, {2});
        const QJsonObject root = jsonOf(*compared);
        QCOMPARE(root["schema"].toString(), QString("dyncal-compare/1"));
        QCOMPARE(root["suggested_order"].toInt(), 2);
        const QJsonObject one = root["orders"][0].toObject();
        const SensorModel &model = *compared->front().model;
        const Pole *main = mainPole(model, compared->front().assessment.get());
        QCOMPARE(one["order"].toInt(), 2);
        QCOMPARE(one["fit_percent"].toDouble(), model.fit_percent);
        QCOMPARE(one["frequency_hz"].toDouble(), main->frequency_Hz);
        QCOMPARE(one["u_damping_ratio"].toDouble(), main->u_dampingRatio);
        QCOMPARE(one["unstable_poles"].toInt(), 0);
        QVERIFY(isExplained(one));
    }

    void candidates_areSuggestionHighOrderAndPinned()
    {
        Recipe recipe;
        recipe.realization.candidates = {5, 3, 5};
        const std::vector<Index> orders = defaultCandidates(calibrated(), recipe);
        QVERIFY(std::is_sorted(orders.begin(), orders.end()));
        for (const Index order : {Index(2), Index(3), Index(5)})
            QCOMPARE(std::count(orders.begin(), orders.end(), order), std::ptrdiff_t(1));
        QCOMPARE(
            orders.back(), std::min<Index>(100, largestOrder(calibrated().decomposition->hankel)));
        QVERIFY(defaultCandidates({}, {}).empty());
    }

    void splitPair_addsTheNextOrder()
    {
        DecompositionResult decomposition = *calibrated().decomposition;
        decomposition.suggestion.order = 1; // half of the sensor's pair
        CalibrationResults results;
        results.decomposition = std::make_shared<const DecompositionResult>(decomposition);
        const std::vector<Index> orders = defaultCandidates(results, {});
        QCOMPARE(
            (std::vector<Index>(orders.begin(), orders.begin() + 2)), (std::vector<Index>{1, 2}));
    }

    void withoutDecomposition_andTooMany_areRefused()
    {
        QVERIFY(compareOrders({}, {}, {2}).error().kind == ErrorKind::Usage);
        const std::vector<Index> many(51, 2);
        QVERIFY(compareOrders(calibrated(), {}, many).error().kind == ErrorKind::Usage);
    }

    void request_stops()
    {
        std::stop_source source;
        source.request_stop();
        const auto compared = compareOrders(calibrated(), {}, {4}, {source.get_token(), {}});
        QVERIFY(compared.error().kind == ErrorKind::Cancelled);
    }

    void evidence_isOfTheDecompositionNotOfTheOrder()
    {
        const auto captures = simulated();
        ResultCache cache;
        const CalibrationResults first
            = runPipeline(captures, {}, cache, StageId::Evidence).results;
        Recipe recipe;
        recipe.realization.order = Index(4);
        recipe.realization.candidates = {2, 4};
        recipe.realization.adoptedReason = "looks best";
        const CalibrationResults second
            = runPipeline(captures, recipe, cache, StageId::Evidence).results;
        QVERIFY(first.evidence && second.evidence == first.evidence); // the same object
        recipe.realization.stableFrequency = 0.001;
        QVERIFY(runPipeline(captures, recipe, cache, StageId::Evidence).results.evidence
            != first.evidence);
    }
};

DYNCAL_TEST(TestOrderComparison)
#include "tst_order_comparison.moc"
