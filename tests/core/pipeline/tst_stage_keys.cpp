// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_keys.h"
#include "core/pipeline/stage_table.h"
#include "tests/support/test_program.h"

#include "core/pipeline/result_cache.h"

#include <QTest>

#include <functional>
#include <set>

using namespace dyncal;

namespace {

using RecipeChange = std::function<void(Recipe &)>;
using CaptureChange = std::function<void(CaptureSet &)>;

constexpr int kNothing = kStageCount; ///< no key moves

CaptureSet captures()
{
    CaptureSet set;
    set.inputs.push_back({"/a/one.h5", "one.h5", "0123", "dyncal-capture"});
    set.tube["driver_length_m"] = "0.97";
    for (const char *label : {"low", "high"}) {
        Shot shot;
        shot.label = label;
        shot.level = shotLevelFromName(label);
        shot.environment.p1_Pa = 101325.0;
        shot.environment.T1_K = 294.0;
        Channel channel;
        channel.name = "DUT";
        channel.role = ChannelRole::Dut;
        channel.samples = RawSamples(std::vector<std::int16_t>{1, 2, 3});
        channel.sampleRate_Hz = 1e8;
        channel.sha256 = "4567";
        shot.channels = {channel};
        set.shots.push_back(shot);
    }
    return set;
}

/// The first stage whose key differs; all later ones must differ too, but for the assessment,
/// which follows the model only, the evidence, which serves all orders and follows the
/// decomposition only, and both Monte Carlos, which follow the shock and the budget. -1 if they do
/// not.
int firstMoved(
    const std::array<std::string, kStageCount> &a, const std::array<std::string, kStageCount> &b)
{
    const auto count = static_cast<std::size_t>(kStageCount);
    std::size_t first = 0;
    while (first < count && a[first] == b[first])
        ++first;
    const auto at = [](StageId stage) { return static_cast<std::size_t>(stage); };
    for (std::size_t i = first; i < count; ++i) {
        bool follows = true;
        if (i == at(StageId::Assessment))
            follows = first == i || first <= at(StageId::Model);
        if (i == at(StageId::Evidence))
            follows = first == i || first <= at(StageId::Decomposition);
        if (i == at(StageId::MonteCarlo))
            follows = first == i || first <= at(StageId::Shock);
        if (i == at(StageId::ChainMonteCarlo)) // reads what the other Monte Carlo reads
            follows = first <= at(StageId::Uncertainty) || first == at(StageId::MonteCarlo);
        if ((a[i] != b[i]) != follows)
            return -1;
    }
    return static_cast<int>(first);
}

} // namespace

class TestStageKeys : public QObject
{
    Q_OBJECT

private slots:
    void recipeChange_movesTheStageThatReadsItAndAllLater_data();
    void recipeChange_movesTheStageThatReadsItAndAllLater();
    void captureChange_movesEveryKey_data();
    void captureChange_movesEveryKey();
    void equalInputs_giveEqualKeys();
    void keys_ofAllStagesDiffer();
    void changeAndBack_givesTheOldKeys();
    void cache_forgetsTheLeastRecentlyUsed();
    void cache_keepsTheFirstOfAKey();
};

void TestStageKeys::recipeChange_movesTheStageThatReadsItAndAllLater_data()
{
    QTest::addColumn<RecipeChange>("change");
    QTest::addColumn<int>("stage");
    const auto row = [](const char *name, StageId stage, const RecipeChange &change) {
        QTest::newRow(name) << change << static_cast<int>(stage);
    };
    const auto import = StageId::Captures;
    row("import.format", import, [](Recipe &r) { r.import.format = "lvm"; });
    row("import.columns", import, [](Recipe &r) { r.import.columns["dut"] = 1; });
    row("import.columns_are", import, [](Recipe &r) { r.import.columnsAre = "shots"; });
    row("import.channels", import, [](Recipe &r) { r.import.channels["DUT"] = "other"; });
    row("import.shots", import, [](Recipe &r) { r.import.shots = {{1, {{"DUT", "other"}}}}; });
    row("import.decimal", import, [](Recipe &r) { r.import.decimal = ","; });
    row("import.separator", import, [](Recipe &r) { r.import.separator = "tab"; });
    row("import.sample_rate", import, [](Recipe &r) { r.import.sampleRate_Hz = 1e7; });
    row("import.unit", import, [](Recipe &r) { r.import.unit = "psi"; });
    row("import.scale", import, [](Recipe &r) { r.import.scale = 2.0; });
    row("import.polarity", import, [](Recipe &r) { r.import.polarity = -1; });
    row("import.reference", import, [](Recipe &r) { r.import.reference = "gauge"; });
    row("import.skip_rows", import, [](Recipe &r) { r.import.skipRows = 4; });
    row("import.interpolate", import, [](Recipe &r) { r.import.interpolateInvalid = 3; });
    row("import.levels", import, [](Recipe &r) { r.import.levels = {"low", "high"}; });
    row("import.rate reason", import, [](Recipe &r) { r.import.sampleRateReason = "known"; });
    row("import.details", import, [](Recipe &r) { r.import.channelDetails["DUT"].gain = 2.0; });
    row("import.files", import, [](Recipe &r) { r.import.files["a.h5"].unit = "psi"; });
    row("checks.saturation", import, [](Recipe &r) { r.checks.saturationRun = 5; });
    row("checks.codes", import, [](Recipe &r) { r.checks.leastCodes = 32.0; });
    row("import.exclude", import, [](Recipe &r) { r.import.exclude = {{1, "leak"}}; });

    const auto window = StageId::Window;
    row("window.start", StageId::Expected, [](Recipe &r) { r.window.start_s = {0.001}; });
    row("window.baseline off", window, [](Recipe &r) { r.window.subtractBaseline = false; });
    row("window.baseline", window, [](Recipe &r) { r.window.baseline_s = Interval{-2e-3, -1e-3}; });
    row("window.end", window, [](Recipe &r) { r.window.end_s = 1e-3; });
    row("window.ends", window, [](Recipe &r) { r.window.ownEnds_s = {1e-3, 2e-3, 1e-3}; });
    row("window.plateau", window, [](Recipe &r) { r.window.endAtPlateau = true; });
    row("window.settle", window, [](Recipe &r) { r.window.settle_s = Interval{5e-4, 1e-3}; });
    row("remap", window, [](Recipe &r) { r.remap = false; });
    row("input.treatment", window,
        [](Recipe &r) { r.input.treatment = ResponseTreatment::StepAsImpulse; });

    // the plateau's end, which the window may end at, follows from the shock
    const auto expected = StageId::Expected;
    row("shock.enabled", expected, [](Recipe &r) { r.shock.enabled = false; });
    row("shock.p1", expected, [](Recipe &r) { r.shock.p1_Pa = 1e5; });
    row("shock.t1", expected, [](Recipe &r) { r.shock.T1_K = 300.0; });
    row("shock.t4", expected, [](Recipe &r) { r.shock.T4_K = 300.0; });
    row("shock.driven gas", expected, [](Recipe &r) { r.shock.drivenGas.gamma = 1.4; });
    row("shock.driver gas", expected,
        [](Recipe &r) { r.shock.driverGas.molarMass_kg_mol = 0.004; });
    row("shock.humidity", expected, [](Recipe &r) { r.shock.relativeHumidity = 0.4; });
    row("shock.velocity", expected, [](Recipe &r) { r.shock.velocity_m_s = 500.0; });
    row("shock.step", expected, [](Recipe &r) { r.shock.step_Pa = 4e5; });
    row("shock.sensors", StageId::Arrivals, [](Recipe &r) {
        r.shock.arrivalSensors = {{"side", 0.5, 1e-3}};
    });
    row("shock.driver length", expected, [](Recipe &r) { r.shock.driverLength_m = 1.0; });
    row("shock.driven length", expected, [](Recipe &r) { r.shock.drivenLength_m = 1.0; });
    row("shock.diameter", expected, [](Recipe &r) { r.shock.innerDiameter_m = 0.1; });
    row("shock.position", expected, [](Recipe &r) { r.shock.dutPosition = "side-wall"; });
    row("shock.front", expected, [](Recipe &r) { r.shock.frontDuration_s = 1e-8; });
    row("shock.u front", expected, [](Recipe &r) { r.shock.u_frontDuration_s = 1e-8; });

    row("shock.velocities", expected, [](Recipe &r) {
        r.shock.velocity_m_s = PerShot({500.0, std::nullopt, 470.0});
    });
    row("shock.largest mach", expected, [](Recipe &r) { r.shock.largestMach = 3.0; });
    row("shock.largest p4", expected, [](Recipe &r) { r.shock.largestDriverPressure_Pa = 1e7; });

    const auto spectrum = StageId::Spectrum;
    row("spectrum.taper", spectrum, [](Recipe &r) { r.spectrum.taper = Taper::Hann; });
    row("spectrum.method", spectrum, [](Recipe &r) { r.spectrum.method = SpectrumMethod::Welch; });
    row("spectrum.segment", spectrum, [](Recipe &r) { r.spectrum.segment = 4096; });
    row("spectrum.detrend", spectrum, [](Recipe &r) { r.spectrum.detrend = Detrend::Linear; });
    row("spectrum.band", spectrum, [](Recipe &r) {
        r.spectrum.resonanceBand_Hz = Interval{1e5, 5e6};
    });
    row("spectrum.search", spectrum, [](Recipe &r) { r.spectrum.searchResonance = false; });
    row("spectrum.resonances", spectrum, [](Recipe &r) {
        r.spectrum.searchResonance = false;
        r.spectrum.resonances_Hz = {2.3e6};
    });

    const auto pca = StageId::Components;
    row("pca.components", pca, [](Recipe &r) { r.pca.components = 2; });
    row("pca.centre", pca, [](Recipe &r) { r.pca.centre = true; });
    row("pca.lags", pca, [](Recipe &r) { r.pca.residualLags = 100; });
    row("pca.confidence", pca, [](Recipe &r) { r.pca.residualConfidence = 0.95; });

    const auto input = StageId::ModelInput;
    row("input.rate", input, [](Recipe &r) { r.input.sampleRate_Hz = 1e7; });
    row("input.samples", input, [](Recipe &r) { r.input.samples = Index(500); });
    row("input.offset", input, [](Recipe &r) { r.input.offset_s = 1e-6; });
    row("input.combine", input, [](Recipe &r) { r.input.combine = CombineMethod::PcaAverage; });

    row("window.exclude", input, [](Recipe &r) {
        r.window.excludeStretches = {{1, 1e-4, 2e-4, "knock"}};
    });
    row("realization.nuisance", input, [](Recipe &r) {
        r.realization.nuisanceModes = {{{6.8e3}, 0, true, "", "tube"}};
    });

    row("realization.max order", StageId::Decomposition,
        [](Recipe &r) { r.realization.maxOrder = 50; });
    row("realization.rows", StageId::Decomposition,
        [](Recipe &r) { r.realization.rows = Index(99); });
    row("realization.order", StageId::Model, [](Recipe &r) { r.realization.order = Index(3); });
    row("realization.refine", StageId::Model, [](Recipe &r) { r.realization.refine = false; });
    row("realization.stable frequency", StageId::Evidence,
        [](Recipe &r) { r.realization.stableFrequency = 0.02; });
    row("realization.stable damping", StageId::Evidence,
        [](Recipe &r) { r.realization.stableDamping = 0.1; });

    const auto response = StageId::Response;
    row("response.grid", response, [](Recipe &r) { r.response.grid = "linear"; });
    row("response.list", response, [](Recipe &r) {
        r.response.grid = "list";
        r.response.frequencies_Hz = {1e3};
    });
    row("response.count", response, [](Recipe &r) {
        r.response.grid = "linear";
        r.response.linearCount = 20;
    });
    row("response.reference", StageId::Reference,
        [](Recipe &r) { r.response.reference = "unit-step"; });

    const auto none = [](const char *name, const RecipeChange &change) {
        QTest::newRow(name) << change << kNothing;
    };
    // read only by a list or a linear grid, or with the search switched off
    none("response.count unused", [](Recipe &r) { r.response.linearCount = 20; });
    none("nothing", [](Recipe &) {});
    const auto shock = StageId::Shock;
    row("uncertainty", StageId::MonteCarlo, [](Recipe &r) { r.uncertainty.coverage = 0.99; });
    row("uncertainty.trials", StageId::MonteCarlo,
        [](Recipe &r) { r.uncertainty.monteCarloTrials = 0; });
    row("uncertainty.seed", StageId::MonteCarlo, [](Recipe &r) { r.uncertainty.seed = 2; });
    row("uncertainty.correlations", shock, [](Recipe &r) {
        r.uncertainty.correlations = {{"p1_pa", "t1_k", 0.5}};
    });
    row("uncertainty.budget", shock, [](Recipe &r) {
        r.uncertainty.budget = {{"p1_pa", 50.0, "normal", {}}};
    });
    none("acknowledge", [](Recipe &r) { r.acknowledge = {{"CAP-014", 1, "seen"}}; });
    none("realization.candidates", [](Recipe &r) { r.realization.candidates = {2, 3}; });
    none("realization.adopted reason", [](Recipe &r) { r.realization.adoptedReason = "seen"; });
    none("certificate", [](Recipe &r) { r.certificate.fields["customer"] = "somebody"; });
}

void TestStageKeys::recipeChange_movesTheStageThatReadsItAndAllLater()
{
    QFETCH(RecipeChange, change);
    QFETCH(int, stage);
    Recipe recipe;
    const auto before = stageKeys(captures(), recipe);
    change(recipe);
    QCOMPARE(firstMoved(before, stageKeys(captures(), recipe)), stage);
}

void TestStageKeys::captureChange_movesEveryKey_data()
{
    QTest::addColumn<CaptureChange>("change");
    const auto row
        = [](const char *name, const CaptureChange &change) { QTest::newRow(name) << change; };
    const auto dut = [](CaptureSet &set) -> Channel & { return set.shots[1].channels[0]; };
    row("file hash", [](CaptureSet &s) { s.inputs[0].sha256 = "89ab"; });
    row("file name", [](CaptureSet &s) { s.inputs[0].file = "two.h5"; });
    row("one shot fewer", [](CaptureSet &s) { s.shots.pop_back(); });
    row("order of shots", [](CaptureSet &s) { std::swap(s.shots[0], s.shots[1]); });
    row("label", [](CaptureSet &s) { s.shots[1].label = "x"; });
    row("level", [](CaptureSet &s) { s.shots[1].level = ShotLevel::Medium; });
    row("included", [](CaptureSet &s) { s.shots[1].included = false; });
    row("p1", [](CaptureSet &s) { s.shots[1].environment.p1_Pa = 1e5; });
    row("u p1", [](CaptureSet &s) { s.shots[1].environment.u_p1_Pa = 50.0; });
    row("T1", [](CaptureSet &s) { s.shots[1].environment.T1_K = 300.0; });
    row("u T1", [](CaptureSet &s) { s.shots[1].environment.u_T1_K = 0.2; });
    row("p4", [](CaptureSet &s) { s.shots[1].environment.p4_Pa = 6e5; });
    row("T4", [](CaptureSet &s) { s.shots[1].environment.T4_K = 300.0; });
    row("ambient", [](CaptureSet &s) { s.shots[1].environment.ambientPressure_Pa = 1e5; });
    row("humidity", [](CaptureSet &s) { s.shots[1].environment.relativeHumidity = 0.5; });
    row("tube", [](CaptureSet &s) { s.tube["driver_length_m"] = "1.2"; });
    row("sample hash", [dut](CaptureSet &s) { dut(s).sha256 = "cdef"; });
    row("channel name", [dut](CaptureSet &s) { dut(s).name = "x"; });
    row("role", [dut](CaptureSet &s) { dut(s).role = ChannelRole::Other; });
    row("rate", [dut](CaptureSet &s) { dut(s).sampleRate_Hz = 5e7; });
    row("t0", [dut](CaptureSet &s) { dut(s).t0_s = -0.01; });
    row("unit", [dut](CaptureSet &s) { dut(s).unit = "Pa"; });
    row("polynomial", [dut](CaptureSet &s) { dut(s).polynomial = {0.0, 2.0}; });
    row("polarity", [dut](CaptureSet &s) { dut(s).polarity = -1.0; });
    row("scale", [dut](CaptureSet &s) { dut(s).userScale = 3.0; });
    row("reference", [dut](CaptureSet &s) { dut(s).reference = PressureReference::Gauge; });
    row("rail", [dut](CaptureSet &s) { dut(s).adcMax = 3.0; });
}

void TestStageKeys::captureChange_movesEveryKey()
{
    QFETCH(CaptureChange, change);
    CaptureSet changed = captures();
    change(changed);
    QCOMPARE(firstMoved(stageKeys(captures(), {}), stageKeys(changed, {})), 0);
}

void TestStageKeys::equalInputs_giveEqualKeys()
{
    QCOMPARE(stageKeys(captures(), {}), stageKeys(captures(), {}));
    CaptureSet moved = captures(); // the same file in another folder
    moved.inputs[0].path = "/elsewhere/one.h5";
    QCOMPARE(stageKeys(moved, {}), stageKeys(captures(), {}));
}

void TestStageKeys::keys_ofAllStagesDiffer()
{
    const auto keys = stageKeys(captures(), {});
    QCOMPARE(std::set<std::string>(keys.begin(), keys.end()).size(), keys.size());
    std::set<std::string> names;
    for (int i = 0; i < kStageCount; ++i)
        names.insert(stageName(static_cast<StageId>(i)));
    QCOMPARE(names.size(), keys.size());
    QVERIFY(!names.contains(""));
}

void TestStageKeys::changeAndBack_givesTheOldKeys()
{
    Recipe recipe;
    const auto before = stageKeys(captures(), recipe);
    recipe.realization.order = Index(5);
    recipe.window.end_s = 0.1;
    QCOMPARE(firstMoved(before, stageKeys(captures(), recipe)), static_cast<int>(StageId::Window));
    recipe.realization.order = {};
    recipe.window.end_s = {};
    QCOMPARE(stageKeys(captures(), recipe), before);
}

void TestStageKeys::cache_forgetsTheLeastRecentlyUsed()
{
    ResultCache cache(2);
    cache.store("a", std::make_shared<const int>(1));
    cache.store("b", std::make_shared<const int>(2));
    QCOMPARE(*cache.find<int>("a"), 1); // now "b" is the older one
    cache.store("c", std::make_shared<const int>(3));
    QVERIFY(!cache.find<int>("b"));
    QCOMPARE(*cache.find<int>("a"), 1);
    QCOMPARE(*cache.find<int>("c"), 3);
    QVERIFY(!cache.find<int>(""));
}

void TestStageKeys::cache_keepsTheFirstOfAKey()
{
    ResultCache cache(2);
    const auto first = std::make_shared<const int>(1);
    cache.store("a", first);
    cache.store("a", std::make_shared<const int>(2));
    QCOMPARE(cache.find<int>("a"), first);
}

DYNCAL_TEST(TestStageKeys)
#include "tst_stage_keys.moc"
