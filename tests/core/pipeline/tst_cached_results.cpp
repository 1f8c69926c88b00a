// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// "Equal keys mean equal results": what comes from the cache is what a run without one gives.

#include "core/capture/capture_seal.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_keys.h"
#include "core/pipeline/stage_table.h"
#include "core/results/results_json.h"
#include "tests/core/project/full_recipe.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <nlohmann/json.hpp>

#include <QTest>

#include <functional>

using namespace dyncal;

using Json = nlohmann::json;
using CaptureChange = std::function<void(CaptureSet &)>;
namespace {

constexpr double kRate_Hz = 5e6;
constexpr double kDuration_s = 0.003;

/// A recipe whose stages all come to their end on the example, so that every stage counts.
Recipe baseRecipe()
{
    Recipe recipe;
    recipe.realization.maxOrder = 12;
    recipe.input.samples = Index(200);
    recipe.uncertainty.monteCarloTrials = 100;
    recipe.uncertainty.budget = {{"t1_k", 0.3, "normal", {}}, {"p1_pa", 50.0, "normal", {}},
        {"distance_m", 1e-4, "normal", {}}};
    return recipe;
}

std::string written(const PipelineOutcome &outcome, const Recipe &recipe)
{
    return resultsJson(outcome, recipe, "2026-01-02T03:04:05Z");
}

std::string fresh(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe)
{
    ResultCache none;
    return written(runPipeline(captures, recipe, none), recipe);
}

/// First line in which two texts differ.
QByteArray difference(const std::string &a, const std::string &b)
{
    const QList<QByteArray> left = QByteArray::fromStdString(a).split('\n');
    const QList<QByteArray> right = QByteArray::fromStdString(b).split('\n');
    for (qsizetype i = 0; i < std::min(left.size(), right.size()); ++i) {
        if (left[i] != right[i])
            return left[i] + " | " + right[i];
    }
    return a == b ? QByteArray() : QByteArray("length");
}

/// Dotted paths of all values below a JSON object that are no objects, or empty ones.
void addLeaves(const Json &value, const std::string &path, std::vector<std::string> &leaves)
{
    if (!value.is_object() || value.empty()) {
        leaves.push_back(path);
        return;
    }
    for (const auto &[key, below] : value.items())
        addLeaves(below, path + "/" + key, leaves);
}

/// Everything that one member of CalibrationResults holds, under the key of its stage.
void copyStage(StageId stage, const CalibrationResults &complete, ResultCache &cache)
{
    cache.store<void>(
        complete.keys[static_cast<std::size_t>(stage)], stageOf(stage).result.get(complete));
}

} // namespace

class TestCachedResults : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void everyKeyOfTheRecipe_cachedIsFresh();
    void everyPartOfTheCaptures_cachedIsFresh_data();
    void everyPartOfTheCaptures_cachedIsFresh();
    void anyStageMissingFromTheCache_givesTheSame();
    void aSmallCache_givesTheSame();

private:
    std::shared_ptr<const CaptureSet> m_captures = testing::simulatedExample(kRate_Hz, kDuration_s);
    const Recipe m_recipe = baseRecipe();
    PipelineOutcome m_outcome;
    std::shared_ptr<ResultCache> m_warm = std::make_shared<ResultCache>(1000);
};

void TestCachedResults::initTestCase()
{
    m_outcome = runPipeline(m_captures, m_recipe, *m_warm);
    QVERIFY2(!m_outcome.error,
        m_outcome.error ? english(m_outcome.error->message).c_str() : "came to its end");
    QVERIFY(m_outcome.results.monteCarlo && !m_outcome.results.monteCarlo->shots.empty());
}

/// One key after the other gets another value; the run may take from the base recipe's results
/// what its keys allow, and must end as without them. Every third key, in the long form all.
void TestCachedResults::everyKeyOfTheRecipe_cachedIsFresh()
{
    const Json base = Json::parse(recipeJson(m_recipe));
    Json other = Json::parse(recipeJson(fullRecipe()));
    other["uncertainty"]["monte_carlo_trials"] = 200; // in place of "adaptive": as good, and quick
    std::vector<std::string> leaves;
    addLeaves(other, "", leaves);
    int changed = 0;
    const auto step = static_cast<std::size_t>(trials::count(3, 1));
    for (std::size_t i = 0; i < leaves.size(); i += step) {
        const std::string &leaf = leaves[i];
        Json mixed = base;
        mixed[Json::json_pointer(leaf)] = other.at(Json::json_pointer(leaf));
        const Result<Recipe> recipe = parseRecipe(mixed.dump());
        if (mixed == base || !recipe)
            continue;
        const std::string cached = written(runPipeline(m_captures, *recipe, *m_warm), *recipe);
        const QByteArray differs = difference(cached, fresh(m_captures, *recipe));
        QVERIFY2(differs.isEmpty(), (leaf + ": " + differs.toStdString()).c_str());
        ++changed;
    }
    qInfo("%d keys changed one by one", changed);
    QVERIFY(changed > trials::count(26, 80));
}

void TestCachedResults::everyPartOfTheCaptures_cachedIsFresh_data()
{
    QTest::addColumn<CaptureChange>("change");
    const auto row
        = [](const char *name, const CaptureChange &change) { QTest::newRow(name) << change; };
    const auto dut = [](CaptureSet &set) -> Channel & {
        for (Channel &channel : set.shots[1].channels) {
            if (channel.role == ChannelRole::Dut)
                return channel;
        }
        return set.shots[1].channels.front();
    };
    row("label", [](CaptureSet &s) { s.shots[1].label = "x"; });
    row("level", [](CaptureSet &s) { s.shots[1].level = ShotLevel::Low; });
    row("included", [](CaptureSet &s) { s.shots[1].included = false; });
    row("exclude reason", [](CaptureSet &s) {
        s.shots[1].included = false;
        s.shots[1].excludeReason = "leak";
    });
    row("notes", [](CaptureSet &s) { s.shots[1].notes["operator"] = "somebody"; });
    row("p1", [](CaptureSet &s) { s.shots[1].environment.p1_Pa *= 1.01; });
    row("T1", [](CaptureSet &s) { s.shots[1].environment.T1_K += 1.0; });
    row("p4", [](CaptureSet &s) { s.shots[1].environment.p4_Pa = 7e5; });
    row("ambient", [](CaptureSet &s) { s.shots[1].environment.ambientT_K = 280.0; });
    row("tube", [](CaptureSet &s) { s.tube["driven_length_m"] = "3.5"; });
    row("sensor", [](CaptureSet &s) { s.sensors["x"]["serial"] = "42"; });
    row("instrument", [](CaptureSet &s) { s.instruments["x"]["serial"] = "42"; });
    // The same bytes, opened by themselves and by a project that expects others (CAP-015).
    row("finding", [](CaptureSet &s) {
        s.inputs[0].expectedSha256 = "4567";
        reportUnexpected(s);
    });
    row("file", [](CaptureSet &s) { s.inputs[0].file = "other"; });
    row("format", [](CaptureSet &s) { s.inputs[0].format = "text"; });
    row("channel's name", [dut](CaptureSet &s) { dut(s).name = "renamed"; });
    row("unit", [dut](CaptureSet &s) { dut(s).unit = "mV"; });
    row("quantity", [dut](CaptureSet &s) { dut(s).quantity = "acceleration"; });
    row("recorded unit", [dut](CaptureSet &s) { dut(s).recordedUnit = "mV"; });
    row("sensor's id", [dut](CaptureSet &s) { dut(s).sensorId = "another"; });
    row("bits", [dut](CaptureSet &s) { dut(s).adcBits = 6; });
    row("rails", [dut](CaptureSet &s) { dut(s).adcMax = 100.0; });
    row("stated hash", [dut](CaptureSet &s) { dut(s).statedSha256 = "0000"; });
    row("t0", [dut](CaptureSet &s) { dut(s).t0_s -= 1e-3; });
    row("polarity", [dut](CaptureSet &s) { dut(s).polarity = -1.0; });
    row("fewer shots", [](CaptureSet &s) { s.shots.pop_back(); });
    row("other order", [](CaptureSet &s) { std::swap(s.shots[0], s.shots[2]); });
}

void TestCachedResults::everyPartOfTheCaptures_cachedIsFresh()
{
    QFETCH(CaptureChange, change);
    auto changed = std::make_shared<CaptureSet>(*m_captures);
    change(*changed);
    const std::string cached = written(runPipeline(changed, m_recipe, *m_warm), m_recipe);
    const QByteArray differs = difference(cached, fresh(changed, m_recipe));
    QVERIFY2(differs.isEmpty(), differs.constData());
}

/// A stage that is computed beside others that are not, whatever was thrown out of the cache.
void TestCachedResults::anyStageMissingFromTheCache_givesTheSame()
{
    const std::string expected = written(m_outcome, m_recipe);
    for (int missing = 0; missing < kStageCount; ++missing) {
        for (const bool alone : {false, true}) { // all but this one, or this one only
            ResultCache cache;
            for (int i = 0; i < kStageCount; ++i) {
                if ((i == missing) == alone)
                    copyStage(static_cast<StageId>(i), m_outcome.results, cache);
            }
            const std::string found = written(runPipeline(m_captures, m_recipe, cache), m_recipe);
            QVERIFY2(found == expected,
                (std::string(stageName(static_cast<StageId>(missing))) + ": "
                    + difference(found, expected).toStdString())
                    .c_str());
        }
    }
}

void TestCachedResults::aSmallCache_givesTheSame()
{
    const std::string expected = written(m_outcome, m_recipe);
    for (const std::size_t capacity : {0U, 1U, 5U}) {
        ResultCache cache(capacity);
        for (int run = 0; run < 2; ++run)
            QCOMPARE(
                difference(written(runPipeline(m_captures, m_recipe, cache), m_recipe), expected),
                QByteArray());
    }
}

DYNCAL_TEST(TestCachedResults)
#include "tst_cached_results.moc"
