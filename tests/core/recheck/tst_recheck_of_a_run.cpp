// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"
#include "core/recheck/recheck_outcome.h"
#include "core/results/results_json.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace dyncal;
using namespace dyncal::testing;
using RealJson = nlohmann::json;

namespace {

/// results.json of a whole simulated calibration, as this program writes it.
const RealJson &realResults()
{
    static const RealJson root = [] {
        ResultCache cache;
        Recipe recipe;
        const PipelineOutcome outcome
            = runPipeline(simulatedExample(10e6, 0.01), recipe, cache, StageId::Uncertainty, {});
        return RealJson::parse(resultsJson(outcome, recipe, "2026-01-01T00:00:00Z"));
    }();
    return root;
}

/// Values on the way to a result, parts of an uncertainty, and what belongs to the model's curve:
/// no quantities that are stated.
const std::set<std::string> kNoStatedQuantity{"u_onset_s", "u_level_relative", "u_arrival_s",
    "u_delay_s", "u_distance_m", "u_velocity_gradient_per_s", "u_noise_magnitude",
    "u_noise_phase_rad", "u_model_magnitude", "u_model_phase_rad", "u_common_relative",
    "u_contains_step", "u_front_duration_s"};

/// Finite numbers at keys that begin with "u", as often as they are there. Below `marked`,
/// `step_budget` and the like nothing is stated anew.
int countU(const RealJson &json)
{
    int count = 0;
    for (const auto &[key, value] : json.items()) {
        if (key == "marked" || key.ends_with("_budget") || key == "monte_carlo"
            || kNoStatedQuantity.contains(key))
            continue;
        const bool isU = key == "u" || key.starts_with("u_");
        if (isU && value.is_number())
            ++count;
        else if (isU && value.is_array())
            count += static_cast<int>(
                std::ranges::count_if(value, [](const RealJson &one) { return one.is_number(); }));
        else if (value.is_structured())
            count += countU(value);
    }
    return count;
}

EarlierRun realRun()
{
    EarlierRun run;
    run.results = realResults();
    return run;
}

} // namespace

/// The tables of core/recheck beside what the program really writes.
class TestRecheckOfARun : public QObject
{
    Q_OBJECT

private slots:
    /// A quantity that is stated with u and that recheck does not know would be missed silently.
    void everyStatedU_isCompared()
    {
        int needed = 0;
        for (const char *section : {"characteristics", "sensitivity", "shots", "shock", "response"})
            needed += countU(realResults()[section]);
        for (const RealJson &pole : realResults()["model"]["poles"])
            needed += pole["im"].get<double>() >= 0.0; // the amplitude of each pair
        const auto pairs = statedQuantities(realResults(), realResults());
        const auto withU = std::ranges::count_if(
            pairs, [](const QuantityPair &pair) { return std::isfinite(pair.u); });
        QCOMPARE(static_cast<int>(withU), needed);
        QVERIFY(needed > 60);
        QCOMPARE(quantityDifferences(pairs).compared(), needed);
    }

    void everyQuantity_hasItsUnitAndAName()
    {
        std::set<std::string> names;
        for (const QuantityPair &pair : statedQuantities(realResults(), realResults())) {
            QVERIFY2(!pair.unit.empty(), pair.of.c_str());
            QVERIFY2(names.insert(pair.of).second, pair.of.c_str());
        }
        for (const char *name : {"f0_hz", "damping_ratio", "sensitivity", "shock[0].velocity_m_s",
                 "shock[0].step_pa", "shots[0].sensitivity", "response.magnitude[0]",
                 "response.phase_rad[0]", "within_5_percent_hz", "q"})
            QVERIFY2(names.contains(name), name);
    }

    void budget_callsTheQuantitiesTheSame()
    {
        std::set<std::string> names;
        for (const QuantityPair &pair : statedQuantities(realResults(), realResults()))
            names.insert(pair.of);
        for (const RealJson &line : realResults()["budget"]) {
            const std::string of = line["of"].get<std::string>();
            if (!of.starts_with("response.marked"))
                QVERIFY2(names.contains(of), of.c_str());
        }
    }

    void ownResults_haveNoDifference()
    {
        const RecheckedRun run = recheckedRun(realRun(), realResults());
        QVERIFY(!run.hasDifferences() && run.methods.empty());
        QVERIFY(run.blockedThen.empty() && run.blockedNow.empty());
        QVERIFY(run.findings.appeared.empty() && run.findings.gone.empty());
        for (const QuantityDifference &one : run.quantities.list)
            QCOMPARE(one.overU, 0.0);
    }

    /// Each characteristic moved by a known share of its U is that share, and nothing else moves.
    void shiftByAShareOfU_isThatShare()
    {
        RealJson now = realResults();
        const std::size_t count = now["characteristics"].size();
        for (std::size_t i = 0; i < count; ++i) {
            RealJson shifted = realResults();
            RealJson &one = shifted["characteristics"][i];
            if (!one["u"].is_number())
                continue;
            const double U = one["u"].get<double>() * one["k"].get<double>();
            one["value"] = one["value"].get<double>() - 1.75 * U;
            const RecheckedRun run = recheckedRun(realRun(), shifted);
            QVERIFY(std::abs(run.quantities.list.front().overU - 1.75) < 1e-6);
            QCOMPARE(run.quantities.list.front().pair.of, one["quantity"].get<std::string>());
            QCOMPARE(run.quantities.largestWithinU(), 0.0);
        }
    }
};

DYNCAL_TEST(TestRecheckOfARun)
#include "tst_recheck_of_a_run.moc"
