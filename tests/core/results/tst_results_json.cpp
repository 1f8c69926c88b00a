// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_json.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Channel dutChannel()
{
    Channel channel;
    channel.name = "DUT";
    channel.role = ChannelRole::Dut;
    channel.samples = RawSamples(std::vector<std::int16_t>(1000, 1));
    channel.sampleRate_Hz = 1e8;
    return channel;
}

std::shared_ptr<const PreparedCaptures> captures()
{
    PreparedCaptures prepared;
    prepared.set.inputs.push_back({"/some/where/optic.h5", "optic.h5", "ab12", "dyncal-capture"});
    Shot shot;
    shot.label = "first";
    shot.level = ShotLevel::Low;
    shot.channels.push_back(dutChannel());
    prepared.set.shots.push_back(shot);
    shot.included = false;
    shot.excludeReason = "diaphragm leaked";
    shot.level = ShotLevel::None;
    prepared.set.shots.push_back(shot);
    Finding finding;
    finding.id = "CAP-017";
    finding.message = {"One shot: %1", {"PCA is skipped"}};
    prepared.findings.push_back(finding);
    return std::make_shared<PreparedCaptures>(prepared);
}

std::shared_ptr<const WindowResult> window()
{
    WindowResult result;
    WindowedResponse response;
    response.shot = 1;
    response.unit = "V";
    response.start_s = 0.01;
    response.step = 2.0;
    response.noiseSd = 0.0;
    response.snr_dB = kInf;
    response.riseTime_s = 2e-7;
    result.responses.push_back(response);
    return std::make_shared<WindowResult>(result);
}

std::shared_ptr<const SpectrumResult> spectrum()
{
    SpectrumResult result;
    PowerSpectrum psd;
    psd.frequency_Hz = Eigen::VectorXd::LinSpaced(20001, 0.0, 50e6);
    psd.psd = Eigen::VectorXd::Constant(20001, 1e-6);
    psd.psd[932] = 1e-2; // 2.33 MHz
    result.perShot.push_back(psd);
    result.resonances.push_back({2.33e6, 40.0, kNan, {2.33e6}});
    return std::make_shared<SpectrumResult>(result);
}

std::shared_ptr<const ComponentResult> components()
{
    ComponentResult result;
    result.shots = {1};
    return std::make_shared<ComponentResult>(result);
}

std::shared_ptr<const ModelInput> modelInput()
{
    ModelInput input;
    input.sampleRate_Hz = 1e7;
    input.samples = 1000;
    input.samplesPerPeriod = 4.3;
    return std::make_shared<ModelInput>(input);
}

std::shared_ptr<const DecompositionResult> decomposition()
{
    DecompositionResult result;
    result.hankel.rows = 499;
    result.hankel.columns = 502;
    result.hankel.singularValues = Eigen::Vector3d(3.0, 2.0, 0.1);
    result.hankel.noiseFloor_p95 = 0.2;
    result.suggestion = {2, {"BIC is smallest at order %1.", {"2"}}, {}};
    return std::make_shared<DecompositionResult>(result);
}

std::shared_ptr<const OrderEvidence> evidence()
{
    OrderEvidence result;
    result.poles = {{2, 2.33e6, 0.02, PoleStability::New, true, 5.0},
        {3, 2.34e6, 0.021, PoleStability::FrequencyAndDamping, false, 4.0}};
    result.fit_percent = Eigen::Vector3d(3.0, 89.0, kNan);
    result.spread = OrderSpread{2, 3, 2.335e6, 5e3, 0.0205, 0.0005};
    result.words = {{"Order 2.", {}}, {"The pole is stable from order %1.", {"2"}}};
    return std::make_shared<OrderEvidence>(result);
}

std::shared_ptr<const SensorModel> model()
{
    SensorModel result;
    result.order = 2;
    result.stateSpace.A = (Eigen::Matrix2d() << 0.1, -0.9, 0.9, 0.1).finished();
    result.stateSpace.B = Eigen::Vector2d(1.0, 0.5);
    result.stateSpace.C = Eigen::RowVector2d(0.25, 0.125);
    result.stateSpace.D = Eigen::MatrixXd::Ones(1, 1);
    result.stateSpace.sampleInterval_s = 1e-7;
    Pole pole;
    pole.z = {0.1, 0.9};
    pole.poleClass = PoleClass::Sensor;
    pole.flags = {"below-noise"};
    pole.frequency_Hz = 2.33e6;
    pole.dampingRatio = 0.0123;
    result.poles = {pole, pole};
    result.poles[1].z = {0.1, -0.9};
    result.zeros = {{0.5, 0.0}};
    SeriesFit fit;
    fit.shot = 1;
    fit.onset_s = 1e-8;
    fit.u_onset_s = 1e-10;
    fit.fit_percent = 87.0;
    result.series.push_back(fit);
    result.plateauGain = 1.0;
    result.fit_percent = 87.0;
    result.fitAttainable_percent = 88.5;
    return std::make_shared<SensorModel>(result);
}

std::shared_ptr<const ShockConditionsSet> shock()
{
    ShockConditionsSet set;
    ShockConditions conditions;
    conditions.shot = 1;
    ShockStates states;
    states.velocity_m_s = 512.8;
    states.mach = 1.49;
    states.driven = {101100.0, 294.15, 1.197, 344.06, 0.0};
    states.shocked = {245000.0, 380.0, 2.2, 391.0, 230.0};
    states.reflected = {536000.0, 480.0, 3.9, 439.0, 0.0};
    states.reflectedVelocity_m_s = 300.0;
    states.reflectedMach = 1.36;
    conditions.states = states;
    conditions.step_Pa = 434900.0;
    conditions.plateau_s = 1.6e-3;
    set.shots.push_back(conditions);
    return std::make_shared<ShockConditionsSet>(set);
}

std::shared_ptr<const ResponseResult> response()
{
    ResponseResult result;
    result.frequency_Hz = Eigen::Vector2d(1e3, 1e6);
    result.magnitude = Eigen::Vector2d(1e-6, 1.2e-6);
    result.u_magnitude = Eigen::Vector2d(kNan, 1e-8);
    result.phase_rad = Eigen::Vector2d(0.0, -0.1);
    result.u_noiseMagnitude = result.u_magnitude;
    result.u_noisePhase_rad = Eigen::Vector2d(0.01, 0.02);
    result.u_frontMagnitude = result.boundEnd = result.boundAlias = Eigen::Vector2d::Zero();
    result.dof = Eigen::Vector2d(9.0, 9.0);
    result.modelMagnitude = result.magnitude;
    result.modelPhase_rad = result.phase_rad;
    result.fLow_Hz = 625.0;
    result.fHigh_Hz = 4e6;
    result.unit = "V/Pa";
    result.characteristics.minus3dB_Hz = 3.5e6;
    result.shots = {{1, 4.6e-6, "V/Pa"}};
    return std::make_shared<ResponseResult>(result);
}

std::shared_ptr<const UncertaintyReport> uncertainty()
{
    UncertaintyReport report;
    report.rows.u_common_relative = 0.01;
    report.rows.u_magnitude = Eigen::Vector2d(kNan, 1.6e-8);
    ReportedValue f0{"f0_hz", 2.33e6, "Hz", {directLine("noise", 30.0, 12.0)}};
    combineLines(f0);
    ReportedValue rise{"rise_time_s", 7e-8, "s"};
    rise.missing = {"the model was not refined", {}};
    report.ofModel = {f0, rise};
    return std::make_shared<UncertaintyReport>(report);
}

PipelineOutcome complete()
{
    PipelineOutcome outcome;
    outcome.results.captures = captures();
    outcome.results.window = window();
    outcome.results.spectrum = spectrum();
    outcome.results.components = components();
    outcome.results.input = modelInput();
    outcome.results.decomposition = decomposition();
    outcome.results.evidence = evidence();
    outcome.results.model = model();
    outcome.results.shock = shock();
    outcome.results.response = response();
    outcome.results.uncertainty = uncertainty();
    return outcome;
}

PipelineOutcome stopped()
{
    PipelineOutcome outcome;
    outcome.results.captures = captures();
    outcome.error = Error{
        ErrorKind::DataBlocked, {"No pressure step found in shot %1.", {"1"}}, "CAP-009", 1};
    outcome.failedStage = StageId::Window;
    return outcome;
}

/// Keys of schema "dyncal-results/1", section by section, as the interface lists them.
const QHash<QString, QStringList> &contract()
{
    static const QHash<QString, QStringList> keys{
        {"software", {"name", "version", "build"}},
        {"shots",
            {"shot", "label", "level", "included", "sample_rate_hz", "samples", "unit", "baseline",
                "step", "noise_sd", "snr_db", "start_s", "onset_s", "u_onset_s", "rise_time_s",
                "rise_time_below_s", "overshoot_percent", "settling_time_s", "sensitivity",
                "sensitivity_unit"}},
        {"shock",
            {"shot", "velocity_m_s", "u_velocity_m_s", "mach", "p1_pa", "p2_pa", "p4_pa", "p5_pa",
                "step_pa", "u_step_pa", "t1_k", "t2_k", "t4_k", "t5_k", "rho1_kg_m3", "rho2_kg_m3",
                "rho4_kg_m3", "rho5_kg_m3", "a1_m_s", "a2_m_s", "a4_m_s", "a5_m_s", "u2_m_s",
                "reflected_velocity_m_s", "reflected_mach", "plateau_s", "f_low_hz"}},
        {"inputs", {"file", "sha256", "format"}},
        {"spectrum", {"frequency_hz", "psd_db", "resonances", "candidates"}},
        {"pca",
            {"explained_cumulative_percent", "components_kept", "residual_rms",
                "residual_whiteness_p", "residual_peaks_hz"}},
        {"input",
            {"treatment", "combine", "sample_rate_hz", "samples", "offset_s", "samples_per_period",
                "lost_response_percent", "excluded_stretches"}},
        {"realization",
            {"rows", "columns", "singular_values", "noise_floor_p95", "suggested_order",
                "suggestion_reason", "adopted_reason", "why", "stability", "fit_by_order_percent",
                "leave_one_out_percent", "spread"}},
        {"model",
            {"order", "dt_s", "A", "B", "C", "D", "poles", "zeros", "fit_percent",
                "fit_attainable_percent", "fit_listing_percent", "fit_per_shot_percent",
                "plateau_gain", "onset_level", "gain_unit", "uncertainty_method", "homogeneity",
                "per_shot", "per_level", "nuisance", "nuisance_effect", "second_order"}},
        {"response",
            {"frequency_hz", "magnitude", "u_magnitude", "k_magnitude", "u_contains_step",
                "phase_rad", "u_phase_rad", "k_phase", "u_noise_magnitude", "u_noise_phase_rad",
                "dof", "bound_end", "bound_alias", "length_s", "bound_alias_assumes",
                "withheld_reason", "u_common_relative", "covariance_re_im", "u_model_magnitude",
                "u_model_phase_rad", "e_n", "front_duration_s", "u_front_duration_s",
                "model_magnitude", "model_phase_rad", "marked", "f_low_hz", "f_high_hz", "unit"}},
        {"bands",
            {"within_5_percent_hz", "within_5_percent_above_hz", "within_5_percent_below_hz",
                "within_10_percent_hz", "within_10_percent_above_hz", "within_10_percent_below_hz",
                "minus_3_db_hz", "minus_3_db_above_hz", "minus_3_db_below_hz", "limit_hz",
                "source"}},
        {"characteristics", {"quantity", "value", "u", "k", "dof", "unit"}},
        {"budget",
            {"of", "quantity", "shot", "value", "u", "distribution", "dof", "sensitivity",
                "contribution", "share_percent"}},
        {"findings",
            {"id", "severity", "shot", "channel", "time_s", "message", "value", "limit", "cause"}},
    };
    return keys;
}

const QStringList kTopLevel{"schema", "software", "created_utc", "recipe", "kind", "inputs",
    "shots", "shock", "spectrum", "pca", "input", "realization", "model", "response", "bands",
    "characteristics", "budget", "gum_validated_by_monte_carlo", "findings", "sensitivity", "drift",
    "echo", "checks", "conformity", "monte_carlo"};

QJsonObject written(const PipelineOutcome &outcome, const Recipe &recipe = {})
{
    const std::string json = resultsJson(outcome, recipe, "2026-01-02T03:04:05Z");
    return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
}

/// Paths of nulls that have no reason beside them; lists take the reason of their own key.
QStringList unexplainedNulls(const QJsonValue &value, const QString &path, bool explained)
{
    QStringList found;
    if (value.isNull() && !explained)
        found << path;
    if (value.isArray()) {
        for (const QJsonValue &element : value.toArray())
            found << unexplainedNulls(element, path + "[]", explained);
    }
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto it = object.begin(); it != object.end(); ++it) {
            if (it.key() == "recipe") // there, null is a setting
                continue;
            const bool hasReason = object[it.key() + "_reason"].toString().size() > 5;
            found << unexplainedNulls(it.value(), path + "." + it.key(), hasReason);
        }
    }
    return found;
}

} // namespace

class TestResultsJson : public QObject
{
    Q_OBJECT

private slots:
    void complete_hasEveryKeyOfTheContract()
    {
        const QJsonObject root = written(complete());
        for (const QString &key : kTopLevel)
            QVERIFY2(root.contains(key), qPrintable(key));
        for (auto section = contract().begin(); section != contract().end(); ++section) {
            const QJsonValue value = root[section.key()];
            const QJsonObject object
                = value.isArray() ? value.toArray().first().toObject() : value.toObject();
            for (const QString &key : section.value())
                QVERIFY2(object.contains(key), qPrintable(section.key() + "." + key));
        }
        const QJsonObject pole = root["model"]["poles"][0].toObject();
        for (const char *key : {"re", "im", "class", "flags", "frequency_hz", "u_frequency_hz",
                 "damping_ratio", "u_damping_ratio", "amplitude"})
            QVERIFY2(pole.contains(QLatin1String(key)), key);
    }

    void complete_holdsTheNumbers()
    {
        const QJsonObject root = written(complete());
        QCOMPARE(root["schema"].toString(), QStringLiteral("dyncal-results/1"));
        QCOMPARE(root["created_utc"].toString(), QStringLiteral("2026-01-02T03:04:05Z"));
        QCOMPARE(root["inputs"][0]["file"].toString(), QStringLiteral("optic.h5"));
        const QJsonValue shot = root["shots"][0];
        QCOMPARE(shot["shot"].toInt(), 1);
        QCOMPARE(shot["level"].toString(), QStringLiteral("low"));
        QCOMPARE(shot["samples"].toInt(), 1000);
        QCOMPARE(shot["onset_s"].toDouble(), 0.01 + 1e-8);
        QCOMPARE(shot["sensitivity"].toDouble(), 4.6e-6);
        QCOMPARE(root["shock"][0]["p5_pa"].toDouble(), 536000.0);
        QCOMPARE(root["shock"][0]["f_low_hz"].toDouble(), 625.0);
        QCOMPARE(root["realization"]["suggested_order"].toInt(), 2);
        QCOMPARE(root["realization"]["suggestion_reason"].toString(),
            QStringLiteral("BIC is smallest at order 2."));
        QCOMPARE(root["model"]["A"][0][1].toDouble(), -0.9);
        QCOMPARE(root["model"]["B"][1][0].toDouble(), 0.5);
        QCOMPARE(root["model"]["poles"][0]["class"].toString(), QStringLiteral("sensor"));
        QCOMPARE(root["model"]["fit_per_shot_percent"][0].toDouble(), 87.0);
        QCOMPARE(root["model"]["gain_unit"].toString(), QStringLiteral("1"));
        QCOMPARE(root["response"]["magnitude"][1].toDouble(), 1.2e-6);
        QCOMPARE(root["bands"]["minus_3_db_hz"].toDouble(), 3.5e6);
        QCOMPARE(
            root["findings"][0]["message"].toString(), QStringLiteral("One shot: PCA is skipped"));
    }

    void bands_beyondTheAnswer_areBounds()
    {
        PipelineOutcome outcome = complete();
        ResponseResult response = *outcome.results.response;
        response.characteristics.within5percent_Hz = 500.0;
        response.characteristics.within10percent_Hz = 1e6;
        response.characteristics.minus3dB_Hz = 3.5e6;
        response.modelLimit_Hz = 2e6;
        outcome.results.response = std::make_shared<const ResponseResult>(response);
        const QJsonObject bands = written(outcome)["bands"].toObject();
        QVERIFY(bands["within_5_percent_hz"].isNull());
        QCOMPARE(bands["within_5_percent_below_hz"].toDouble(), 625.0);
        QCOMPARE(bands["within_5_percent_hz_reason"].toString(),
            QStringLiteral("below 625 Hz (the band of the response begins there)"));
        QCOMPARE(bands["within_10_percent_hz"].toDouble(), 1e6);
        QVERIFY(bands["within_10_percent_above_hz"].isNull());
        QVERIFY(!bands["within_10_percent_above_hz_reason"].toString().isEmpty());
        QVERIFY(bands["minus_3_db_hz"].isNull());
        QCOMPARE(bands["minus_3_db_above_hz"].toDouble(), 2e6);
        QCOMPARE(bands["limit_hz"].toDouble(), 2e6);
    }

    void riseWithinTwoSamples_isABound()
    {
        PipelineOutcome outcome = complete();
        WindowResult window = *outcome.results.window;
        window.responses[0].sampleRate_Hz = 5e6; // rises within 200 ns
        outcome.results.window = std::make_shared<const WindowResult>(window);
        const QJsonObject shot = written(outcome)["shots"].toArray()[0].toObject();
        QVERIFY(shot["rise_time_s"].isNull());
        QCOMPARE(shot["rise_time_below_s"].toDouble(), 4e-7);
        QCOMPARE(shot["rise_time_s_reason"].toString(),
            QString::fromUtf8("It is below 400 ns (two samples)."));
    }

    void kind_isWritten()
    {
        PipelineOutcome outcome = complete();
        QCOMPARE(written(outcome)["kind"].toString(), QStringLiteral("computed-step"));
        ModelInput input = *outcome.results.input;
        input.treatment = ResponseTreatment::Impulse;
        outcome.results.input = std::make_shared<const ModelInput>(input);
        QCOMPARE(written(outcome)["kind"].toString(), QStringLiteral("free-decay"));
    }

    void evidence_isWrittenOrExplained()
    {
        PipelineOutcome outcome = complete();
        Recipe recipe;
        recipe.realization.adoptedReason = "lowest order that fits";
        QJsonObject section = written(outcome, recipe)["realization"].toObject();
        QCOMPARE(section["adopted_reason"].toString(), QStringLiteral("lowest order that fits"));
        QCOMPARE(section["why"][1].toString(), QStringLiteral("The pole is stable from order 2."));
        const QJsonObject stability = section["stability"].toObject();
        QCOMPARE(stability["order"], QJsonValue(QJsonArray{2, 3}));
        QCOMPARE(stability["stability"], QJsonValue(QJsonArray{"new", "frequency-and-damping"}));
        QCOMPARE(stability["stands_out"], QJsonValue(QJsonArray{true, false}));
        QCOMPARE(stability["frequency_hz"][1].toDouble(), 2.34e6);
        QVERIFY(section["fit_by_order_percent"][2].isNull()); // diverges
        QVERIFY(section["fit_by_order_percent_reason"].toString().contains("diverges"));
        QVERIFY(section["leave_one_out_percent"].isNull());
        const QJsonObject spread = section["spread"].toObject();
        QCOMPARE(spread["to_order"].toInt(), 3);
        QCOMPARE(spread["frequency_spread_hz"].toDouble(), 5e3);

        outcome.results.evidence = nullptr;
        section = written(outcome)["realization"].toObject();
        for (const char *key : {"why", "stability", "spread", "adopted_reason"}) {
            QVERIFY2(section[QLatin1String(key)].isNull(), key);
            QVERIFY2(section.contains(QString(key) + "_reason"), key);
        }
    }

    void spectrum_isThinnedAndKeepsThePeak()
    {
        const QJsonValue section = written(complete()).value("spectrum");
        const QJsonArray frequency = section["frequency_hz"].toArray();
        const QJsonArray decibels = section["psd_db"][0].toArray();
        QVERIFY(frequency.size() <= 4096);
        QCOMPARE(frequency.size(), decibels.size());
        double highest = -kInf;
        double where = 0.0;
        for (qsizetype i = 0; i < decibels.size(); ++i) {
            if (decibels[i].toDouble() > highest) {
                highest = decibels[i].toDouble();
                where = frequency[i].toDouble();
            }
        }
        QCOMPARE(highest, -20.0); // 10 log10(1e-2)
        QCOMPARE(where, 2.33e6);
    }

    void everyNull_hasItsReason()
    {
        for (const PipelineOutcome &outcome : {complete(), stopped(), PipelineOutcome()})
            QCOMPARE(unexplainedNulls(written(outcome), "", false), QStringList());
    }

    void text_holdsNoNanAndNoInfinity()
    {
        const std::string json = resultsJson(complete(), {}, "x");
        for (const char *word : {": nan", ": inf", ": -inf", "NaN", "Infinity"})
            QVERIFY2(json.find(word) == std::string::npos, word);
        QVERIFY(written(complete()).value("shots")[0]["snr_db"].isNull());
        QVERIFY(written(complete()).value("response")["u_magnitude"][0].isNull());
    }

    void stopped_keepsEverySectionAndSaysWhy()
    {
        const QJsonObject root = written(stopped());
        for (const QString &key : kTopLevel)
            QVERIFY2(root.contains(key), qPrintable(key));
        const QString why = QStringLiteral("No pressure step found in shot 1.");
        for (const char *section :
            {"shock", "spectrum", "pca", "input", "realization", "model", "response", "bands"}) {
            QVERIFY2(root[QLatin1String(section)].isNull(), section);
            const QString reason
                = root[QLatin1String(section) + QLatin1String("_reason")].toString();
            QVERIFY2(reason.contains(why), section);
        }
        QCOMPARE(root["shots"].toArray().size(), 2);
        QVERIFY(root["shots"][0]["step"].isNull());
        QVERIFY(root["shots"][0]["step_reason"].toString().contains(why));
        QVERIFY(root["shots"][1]["step_reason"].toString().contains("diaphragm leaked"));
        QCOMPARE(root["error"]["message"].toString(), why);
    }

    void stopped_listsTheErrorAmongTheFindings()
    {
        const QJsonArray findings = written(stopped()).value("findings").toArray();
        QCOMPARE(findings.size(), 2);
        QCOMPARE(findings[1]["id"].toString(), QStringLiteral("CAP-009"));
        QCOMPARE(findings[1]["severity"].toString(), QStringLiteral("block"));
        QCOMPARE(findings[1]["shot"].toInt(), 1);
    }

    void errorThatIsAFindingAlready_isListedOnce()
    {
        PipelineOutcome outcome = stopped();
        PreparedCaptures prepared = *outcome.results.captures;
        Finding same;
        same.id = "CAP-009";
        same.severity = Severity::Block;
        same.shot = 1;
        prepared.findings = {same};
        outcome.results.captures = std::make_shared<PreparedCaptures>(prepared);
        QCOMPARE(allFindings(outcome).size(), std::size_t(1));
        same.shot = 2; // of another shot: both stay
        prepared.findings = {same};
        outcome.results.captures = std::make_shared<PreparedCaptures>(prepared);
        QCOMPARE(allFindings(outcome).size(), std::size_t(2));
    }

    void shockSwitchedOff_isNullWithThatReason()
    {
        Recipe recipe;
        recipe.shock.enabled = false;
        const QJsonObject root = written(complete(), recipe);
        QVERIFY(root["shock"].isNull());
        QVERIFY(root["shock_reason"].toString().contains("shock.enabled"));
    }

    void recipe_isTheOneUsedWithDefaultsFilledIn()
    {
        Recipe recipe;
        recipe.realization.order = Index(7);
        const QJsonObject section = written(complete(), recipe).value("recipe").toObject();
        const Result<Recipe> read = parseRecipe(QJsonDocument(section).toJson().toStdString());
        QVERIFY(read.has_value());
        QVERIFY(*read == recipe);
        QCOMPARE(section["pca"]["residual_lags"].toInt(), 500);
    }

    void sameResults_giveTheSameBytes()
    {
        QVERIFY(resultsJson(complete(), {}, "t") == resultsJson(complete(), {}, "t"));
    }

    void layout_isSortedIndentedAndEndsWithOneLineFeed()
    {
        const std::string json = resultsJson(complete(), {}, "t");
        QVERIFY(json.starts_with("{\n  \"bands\": {\n    \"limit_hz\": 4000000.0,"));
        QVERIFY(json.ends_with("\n}\n"));
        QVERIFY(json.find('\r') == std::string::npos);
    }

    void numbers_roundTrip()
    {
        PipelineOutcome outcome = complete();
        SensorModel changed = *outcome.results.model;
        const double awkward = 0.1 + 0.2;
        changed.fit_percent = awkward;
        outcome.results.model = std::make_shared<SensorModel>(changed);
        QCOMPARE(written(outcome).value("model")["fit_percent"].toDouble(), awkward);
        QVERIFY(resultsJson(outcome, {}, "t").find("0.30000000000000004") != std::string::npos);
    }

    void labelInForeignEncoding_stillGivesUtf8()
    {
        PipelineOutcome outcome = complete();
        PreparedCaptures prepared = *outcome.results.captures;
        prepared.set.shots[0].label = "\xe5ng";
        outcome.results.captures = std::make_shared<PreparedCaptures>(prepared);
        QVERIFY(!written(outcome).isEmpty());
    }

    void modelOfTheAverage_hasNoOnsetPerShot()
    {
        PipelineOutcome outcome = complete();
        SensorModel changed = *outcome.results.model;
        changed.series[0].shot = 0;
        outcome.results.model = std::make_shared<SensorModel>(changed);
        const QJsonObject root = written(outcome);
        QVERIFY(root["shots"][0]["onset_s"].isNull());
        QVERIFY(root["model"]["fit_per_shot_percent"].isNull());
    }
};

DYNCAL_TEST(TestResultsJson)
#include "tst_results_json.moc"
