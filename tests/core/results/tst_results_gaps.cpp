// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// results.json with something missing: any one stage, everything behind a stage, any number.

#include "core/results/results_context.h"
#include "core/results/results_json.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <functional>

using namespace dyncal;
using Json = nlohmann::json;

namespace {

using Removal = std::function<void(CalibrationResults &)>;

/// Stages in the order of the pipeline, and the section of results.json that goes with each.
const std::vector<std::pair<const char *, Removal>> &removals()
{
    static const std::vector<std::pair<const char *, Removal>> list{
        {"shots", [](CalibrationResults &r) { r.captures = nullptr; }},
        {"", [](CalibrationResults &r) { r.window = nullptr; }},
        {"spectrum", [](CalibrationResults &r) { r.spectrum = nullptr; }},
        {"pca", [](CalibrationResults &r) { r.components = nullptr; }},
        {"input", [](CalibrationResults &r) { r.input = nullptr; }},
        {"realization", [](CalibrationResults &r) { r.decomposition = nullptr; }},
        {"", [](CalibrationResults &r) { r.assessment = nullptr; }},
        {"model",
            [](CalibrationResults &r) {
                r.model = nullptr;
                r.assessment = nullptr; // which speaks of it
            }},
        {"shock", [](CalibrationResults &r) { r.shock = nullptr; }},
        {"response", [](CalibrationResults &r) { r.response = nullptr; }}};
    return list;
}

/// Paths of nulls without a reason beside them or above.
std::vector<std::string> unexplained(const Json &value, const std::string &path, bool explained)
{
    std::vector<std::string> found;
    const auto add = [&](const Json &part, const std::string &name, bool hasReason) {
        for (std::string &one : unexplained(part, path + name, hasReason))
            found.push_back(std::move(one));
    };
    if (value.is_null() && !explained)
        found.push_back(path);
    if (value.is_array()) {
        for (const Json &part : value)
            add(part, "[]", explained);
    }
    if (value.is_object()) {
        for (const auto &[key, part] : value.items()) {
            const auto reason = value.find(key + "_reason");
            const bool hasReason = reason != value.end() && reason->is_string()
                && reason->get<std::string>().size() > 5;
            if (path.empty() && key == "recipe") // there, null is a setting
                continue;
            add(part, "." + key, hasReason);
        }
    }
    return found;
}

Json written(const PipelineOutcome &outcome)
{
    return Json::parse(resultsJson(outcome, {}, "2026-01-02T03:04:05Z"));
}

/// The example with everything that a model may bring along.
PipelineOutcome whole()
{
    PipelineOutcome outcome;
    outcome.results = example::calibration();
    SensorModel model = *outcome.results.model;
    ModelAssessment assessment = *outcome.results.assessment;
    assessment.homogeneity = Homogeneity{2.33e6, 1.5, 2.0, 0.4, true};
    assessment.perShot.resize(2);
    assessment.perShot[0] = {{1}, ShotLevel::Low, 2.0, 2.33e6, 400.0, 0.02, 1e-4, 1.0, 1e-3, 2.0};
    assessment.perLevel = assessment.perShot;
    assessment.secondOrder.emplace();
    assessment.secondOrder->shots.resize(3);
    assessment.nuisanceEffect.emplace();
    NuisanceMode mode{{6.8e3}, 1, true, "transverse", "rings"};
    model.nuisance = {{mode, {NuisanceOfShot{1, {0, true, {-40.0, 4e4}, {0.01, 0.0}}}}}};
    outcome.results.model = std::make_shared<const SensorModel>(model);
    outcome.results.assessment = std::make_shared<const ModelAssessment>(assessment);
    OrderEvidence evidence;
    evidence.fit_percent = Eigen::Vector3d(10.0, 98.0, kUnknown);
    outcome.results.evidence = std::make_shared<const OrderEvidence>(evidence);
    return outcome;
}

void spoil(std::vector<Pole> &poles)
{
    const double nan = kUnknown;
    for (Pole &pole : poles) {
        pole.frequency_Hz = pole.u_frequency_Hz = pole.dampingRatio = pole.u_dampingRatio = nan;
        pole.amplitude = pole.coverageFactor = nan;
        pole.z = {nan, nan};
    }
}

void spoil(SensorModel &model)
{
    const double nan = kUnknown;
    spoil(model.poles);
    model.stateSpace.A = Eigen::MatrixXd::Constant(2, 2, nan);
    model.stateSpace.B = Eigen::MatrixXd::Constant(2, 1, nan);
    model.fit_percent = model.fitAttainable_percent = model.plateauGain = nan;
    for (SeriesFit &fit : model.series)
        fit.onset_s = fit.u_onset_s = fit.fit_percent = nan;
    NuisanceOfShot &mode = model.nuisance[0].perShot[0];
    mode.term.pole_rad_s = {nan, nan};
    mode.relativeAmplitude = mode.phase_rad = nan;
}

void spoil(ModelAssessment &assessment)
{
    const double nan = kUnknown;
    spoil(assessment.poles);
    assessment.homogeneity = Homogeneity{nan, nan, nan, nan, false};
    for (LevelPole &level : assessment.perShot)
        level = {{9}, ShotLevel::None, nan, nan, nan, nan, nan, nan, nan, nan};
    SecondOrderModel &second = *assessment.secondOrder;
    second.f0_Hz = second.u_f0_Hz = second.zeta = second.u_zeta = second.coverageFactor = nan;
    second.fit_percent = second.residualToNoise = nan;
    for (SecondOrderShot &shot : second.shots)
        shot = {1, nan, nan, nan, nan, nan};
}

} // namespace

class TestResultsGaps : public QObject
{
    Q_OBJECT

private slots:
    void anyOneStageMissing_isExplained()
    {
        for (const auto &[section, remove] : removals()) {
            PipelineOutcome outcome = whole();
            remove(outcome.results);
            const Json root = written(outcome);
            QCOMPARE(unexplained(root, "", false), std::vector<std::string>());
            if (*section != '\0')
                QVERIFY2(root.contains(section) && root[section].is_null(), section);
        }
    }

    void everythingBehindAStageMissing_namesTheError()
    {
        // As a run that stopped: the sentence of its error stands wherever something is missing.
        for (std::size_t first = 0; first < removals().size(); ++first) {
            PipelineOutcome outcome = whole();
            outcome.error = Error{ErrorKind::DataBlocked, {"Cable %1 is off.", {"7"}}, "X-001", 2};
            for (std::size_t i = first; i < removals().size(); ++i)
                removals()[i].second(outcome.results);
            outcome.results.evidence = nullptr;
            const Json root = written(outcome);
            QCOMPARE(unexplained(root, "", false), std::vector<std::string>());
            for (std::size_t i = first; i < removals().size(); ++i) {
                const std::string section = removals()[i].first;
                if (section.empty())
                    continue;
                const std::string reason = root[section + "_reason"];
                QVERIFY2(reason.find("Cable 7 is off.") != std::string::npos, section.c_str());
            }
        }
    }

    void numbersThatAreNone_areExplained()
    {
        PipelineOutcome outcome = whole();
        SensorModel model = *outcome.results.model;
        spoil(model);
        outcome.results.model = std::make_shared<const SensorModel>(model);
        ModelAssessment assessment = *outcome.results.assessment;
        spoil(assessment);
        outcome.results.assessment = std::make_shared<const ModelAssessment>(assessment);
        WindowResult window = *outcome.results.window;
        WindowedResponse &first = window.responses.front();
        first.baseline = first.step = first.noiseSd = first.snr_dB = first.start_s = kUnknown;
        first.riseTime_s = first.overshoot_percent = first.settlingTime_s = std::nullopt;
        outcome.results.window = std::make_shared<const WindowResult>(window);
        ResponseResult response = *outcome.results.response;
        response.magnitude[3] = response.phase_rad[0] = response.modelMagnitude[1] = kUnknown;
        response.u_magnitude.setConstant(kUnknown);
        response.fLow_Hz = kUnknown;
        outcome.results.response = std::make_shared<const ResponseResult>(response);
        ShockConditionsSet shock = *outcome.results.shock;
        shock.shots[0].states->velocity_m_s = shock.shots[1].states->driven.density_kg_m3
            = kUnknown;
        shock.shots[2].states.reset();
        shock.shots[1].step_Pa = shock.shots[1].plateau_s = std::nullopt;
        outcome.results.shock = std::make_shared<const ShockConditionsSet>(shock);
        outcome.results.uncertainty = example::uncertaintyOf(outcome.results);
        const Json root = written(outcome);
        QCOMPARE(unexplained(root, "", false), std::vector<std::string>());
        QVERIFY(root["model"]["second_order"]["f0_hz"].is_null());
        QVERIFY(root["response"]["magnitude"][3].is_null());
        QVERIFY(root["response"]["magnitude"][2].is_number());
    }

    void shotThatIsNotThere_hasNothing()
    {
        const PipelineOutcome outcome = whole();
        const Recipe recipe;
        const ResultsContext context{outcome, recipe};
        QCOMPARE(context.responseOf(2)->shot, Index(2));
        QCOMPARE(context.fitOf(3)->shot, Index(3));
        for (const Index shot : {Index(0), Index(4), Index(-1)}) {
            QVERIFY(context.responseOf(shot) == nullptr);
            QVERIFY(context.fitOf(shot) == nullptr);
        }
        const PipelineOutcome nothing;
        QVERIFY((ResultsContext{nothing, recipe}.responseOf(1) == nullptr));
        QVERIFY((ResultsContext{nothing, recipe}.fitOf(1) == nullptr));
    }

    void meanSensitivity_isOfAllTheShotsOrNone()
    {
        // A mean over the shots that happen to have a step would be that of another group.
        PipelineOutcome outcome = whole();
        ModelAssessment assessment = *outcome.results.assessment;
        assessment.perLevel[0].shots = {1, 3};
        outcome.results.assessment = std::make_shared<const ModelAssessment>(assessment);
        ResponseResult response = *outcome.results.response;
        response.shots = {{1, 1e-6, "V/Pa"}, {2, 5e-6, "V/Pa"}, {3, 2e-6, "V/Pa"}};
        outcome.results.response = std::make_shared<const ResponseResult>(response);
        QCOMPARE(written(outcome)["model"]["per_level"][0]["sensitivity"], Json(1.5e-6));
        response.shots[2].sensitivity.reset();
        outcome.results.response = std::make_shared<const ResponseResult>(response);
        const Json level = written(outcome)["model"]["per_level"][0];
        QVERIFY(level["sensitivity"].is_null() && level.contains("sensitivity_reason"));
    }
};

DYNCAL_TEST(TestResultsGaps)
#include "tst_results_gaps.moc"
