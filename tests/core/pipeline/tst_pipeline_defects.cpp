// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Faulty shots through the whole method: each fault ends in the finding or the error it must.

#include "core/pipeline/pipeline.h"
#include "core/results/results_json.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <span>

using namespace dyncal;

namespace {

const Pole *mainPoleOf(const PipelineOutcome &outcome)
{
    return mainPole(*outcome.results.model, outcome.results.assessment.get());
}

constexpr Index kQuickTrials = 100; // of a defect nothing depends on their number

SimulationSettings settingsFor(const std::string &preset)
{
    SimulationSettings settings;
    settings.sensor = sensorPreset(preset).value();
    settings.duration_s = 0.004;
    return settings;
}

PipelineOutcome calibrated(const SimulationSettings &settings, Recipe recipe = {})
{
    recipe.uncertainty.monteCarloTrials = kQuickTrials;
    ResultCache cache;
    return runPipeline(
        std::make_shared<const CaptureSet>(simulateShots(settings).value().set), recipe, cache);
}

QJsonObject written(const PipelineOutcome &outcome, const Recipe &recipe = {})
{
    const QByteArray json
        = QByteArray::fromStdString(resultsJson(outcome, recipe, "2026-01-02T03:04:05Z"));
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    return error.error == QJsonParseError::NoError ? document.object() : QJsonObject();
}

/// Findings of that id; with a shot only those of the shot.
Findings findingsOf(const PipelineOutcome &outcome, const std::string &id, Index shot = 0)
{
    Findings found = allFindings(outcome);
    std::erase_if(found, [&](const Finding &finding) {
        return finding.id != id || (shot != 0 && finding.shot != shot);
    });
    return found;
}

/// Top level of schema "dyncal-results/1".
const QStringList kSections{"schema", "software", "created_utc", "recipe", "inputs", "shots",
    "shock", "spectrum", "pca", "input", "realization", "model", "response", "bands", "budget",
    "gum_validated_by_monte_carlo", "findings"};

/// What is wrong with the results file of an outcome; empty if nothing is. A null at the top level
/// has its reason, and the error that stopped the run is among the findings.
QString faultOfJson(const PipelineOutcome &outcome, const Recipe &recipe = {})
{
    const QJsonObject root = written(outcome, recipe);
    if (root.isEmpty())
        return "is no JSON";
    for (const QString &key : kSections) {
        if (!root.contains(key))
            return "lacks " + key;
        if (root[key].isNull() && root[key + "_reason"].toString().size() < 5)
            return "does not say why null: " + key;
    }
    const std::string text = resultsJson(outcome, recipe, "t");
    for (const char *word : {": nan", ": -nan", ": inf", ": -inf", "NaN", "Infinity"}) {
        if (text.find(word) != std::string::npos)
            return QString("holds ") + word;
    }
    const QJsonArray findings = root["findings"].toArray();
    if (findings.size() != static_cast<qsizetype>(allFindings(outcome).size()))
        return "holds other findings than the run";
    return {};
}

bool isSentence(const Message &message)
{
    static const QRegularExpression unfilled("%\\d|\\bnan\\b|\\binf\\b|\\de[+]\\d");
    const QString text = QString::fromStdString(english(message));
    return text.size() > 20 && text.endsWith('.') && !text.contains(unfilled);
}

} // namespace

class TestPipelineDefects : public QObject
{
    Q_OBJECT

private slots:
    void defect_endsInItsFinding_data();
    void defect_endsInItsFinding();
    void clean_hasNoCaution();
    void blockedShot_excluded_letsTheOthersThrough_data();
    void blockedShot_excluded_letsTheOthersThrough();
    void invalidSamples_interpolated_areUsed();
    void mislabelledUnit_corrected_isAsWithoutTheDefect();
    void allDefectsAtOnce_areAnErrorNotACrash();
    void rates_100and60megahertz_giveTheSameSensor();
    void oneShot_isEnough();
    void allShotsExcluded_isOneSentence();
    void emptySet_isOneSentence();
    void order_tooLarge_isOneUsageSentence_data();
    void order_tooLarge_isOneUsageSentence();
    void order_thatDiverges_hasNullFitAndAReason();
};

void TestPipelineDefects::defect_endsInItsFinding_data()
{
    QTest::addColumn<QString>("defect");
    QTest::addColumn<QString>("finding");
    QTest::addColumn<int>("severity");
    QTest::addColumn<bool>("stops"); ///< there is an error instead of a result
    const auto row = [](const char *defect, const char *finding, Severity severity, bool stops) {
        const std::vector<const char *> all{"@2", "", "@1", "@3"}; // the suite has the first
        for (const char *shot : std::span(all).first(std::size_t(trials::count(1, 4))))
            QTest::addRow("%s%s %s", defect, shot, finding)
                << QString("%1%2").arg(defect, shot) << finding << static_cast<int>(severity)
                << stops;
    };
    row("clip", "CAP-007", Severity::Block, true);
    row("nan", "CAP-006", Severity::Block, true);
    row("nostep", "CAP-009", Severity::Block, true);
    row("swap", "SHK-001", Severity::Block, false);
    row("swap", "CAP-010", Severity::Caution, false);
    row("drift", "WIN-004", Severity::Caution, false);
    row("psi", "CAP-013", Severity::Caution, false);
    QTest::newRow("short@2") << "short@2"
                             << "CAP-005" << static_cast<int>(Severity::Info) << false;
    QTest::newRow("short") << "short"
                           << "CAP-005" << static_cast<int>(Severity::Info) << false;
    QTest::newRow("fs50@2") << "fs50@2"
                            << "CAP-004" << static_cast<int>(Severity::Caution) << false;
    QTest::newRow("ringvar") << "ringvar"
                             << "PCA-001" << static_cast<int>(Severity::Caution) << false;
    QTest::newRow("ringvar@3") << "ringvar@3"
                               << "PCA-004" << static_cast<int>(Severity::Caution) << false;
}

void TestPipelineDefects::defect_endsInItsFinding()
{
    QFETCH(QString, defect);
    QFETCH(QString, finding);
    QFETCH(int, severity);
    QFETCH(bool, stops);
    SimulationSettings settings = settingsFor("optic3");
    settings.defects = {parseDefect(defect.toStdString()).value()};
    const PipelineOutcome outcome = calibrated(settings);
    QCOMPARE(outcome.error.has_value(), stops);
    const Index shot = settings.defects.front().shot;
    const bool ofAllShots = finding == "CAP-005" || finding == "CAP-004";
    const Findings found = findingsOf(outcome, finding.toStdString(), ofAllShots ? Index(0) : shot);
    QVERIFY2(!found.empty(), qPrintable(finding));
    QCOMPARE(static_cast<int>(worstSeverity(found)), severity);
    if (stops) {
        QCOMPARE(outcome.error->kind, ErrorKind::DataBlocked);
        QCOMPARE(outcome.error->findingId, finding.toStdString());
        QCOMPARE(outcome.error->shot, std::max(shot, Index(1)));
        QVERIFY2(isSentence(outcome.error->message), english(outcome.error->message).c_str());
        QVERIFY(!outcome.results.response);
    }
    for (const Finding &each : allFindings(outcome))
        QVERIFY2(isSentence(each.message), english(each.message).c_str());
    const QString fault = faultOfJson(outcome);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestPipelineDefects::clean_hasNoCaution()
{
    const PipelineOutcome outcome = calibrated(settingsFor("optic3"));
    QVERIFY(!outcome.error);
    for (const Finding &finding : allFindings(outcome))
        QVERIFY2(finding.severity == Severity::Info, english(finding.message).c_str());
    QCOMPARE(faultOfJson(outcome), QString());
    const QJsonObject root = written(outcome);
    for (const char *section :
        {"shock", "spectrum", "pca", "input", "realization", "model", "response", "bands"})
        QVERIFY2(!root[QLatin1String(section)].isNull(), section);
}

void TestPipelineDefects::blockedShot_excluded_letsTheOthersThrough_data()
{
    QTest::addColumn<QString>("defect");
    for (const char *defect : {"clip@2", "nan@2", "nostep@2", "swap@2", "psi@2", "drift@2"})
        QTest::newRow(defect) << defect;
}

void TestPipelineDefects::blockedShot_excluded_letsTheOthersThrough()
{
    QFETCH(QString, defect);
    SimulationSettings settings = settingsFor("optic3");
    settings.defects = {parseDefect(defect.toStdString()).value()};
    Recipe recipe;
    recipe.import.exclude = {{2, "faulty"}};
    const PipelineOutcome outcome = calibrated(settings, recipe);
    QVERIFY2(outcome.results.response, qPrintable(defect));
    QCOMPARE(outcome.results.window->responses.size(), std::size_t(2));
    QCOMPARE(faultOfJson(outcome, recipe), QString());

    // the other shots are the same, so are the numbers
    static const PipelineOutcome clean = calibrated(settingsFor("optic3"), recipe);
    QCOMPARE(outcome.results.model->poles.front().frequency_Hz,
        clean.results.model->poles.front().frequency_Hz);
    QCOMPARE(outcome.results.response->sensitivity, clean.results.response->sensitivity);
}

void TestPipelineDefects::invalidSamples_interpolated_areUsed()
{
    SimulationSettings settings = settingsFor("optic3");
    settings.defects = {{DefectKind::Nan, 2}};
    Recipe recipe;
    recipe.import.interpolateInvalid = 3;
    const PipelineOutcome outcome = calibrated(settings, recipe);
    QVERIFY(outcome.results.response);
    QVERIFY(!findingsOf(outcome, "CAP-022", 2).empty()); // recorded for the certificate
    QVERIFY(std::abs(mainPoleOf(outcome)->frequency_Hz / 2.33e6 - 1.0) < 1e-3);
    recipe.import.interpolateInvalid = 2; // the gap has three samples
    QCOMPARE(calibrated(settings, recipe).error.value().findingId, std::string("CAP-006"));
}

void TestPipelineDefects::mislabelledUnit_corrected_isAsWithoutTheDefect()
{
    SimulationSettings settings = settingsFor("optic3");
    settings.defects = {{DefectKind::Psi, 0}};
    Recipe recipe;
    recipe.import.unit = "psi";
    const PipelineOutcome outcome = calibrated(settings, recipe);
    QVERIFY(outcome.results.response);
    QVERIFY(findingsOf(outcome, "CAP-013").empty());
    // the simulated scale is exact: psi in, converted to Pa, so 1 Pa is read per Pa
    constexpr double kTolerance = 0.01; ///< of the plateau level and the computed step
    QVERIFY(std::abs(*outcome.results.response->sensitivity - 1.0) < kTolerance);
    QCOMPARE(outcome.results.response->sensitivityUnit, std::string("Pa/Pa"));
}

void TestPipelineDefects::allDefectsAtOnce_areAnErrorNotACrash()
{
    SimulationSettings settings = settingsFor("optic3");
    for (const DefectKind kind :
        {DefectKind::Clip, DefectKind::Nan, DefectKind::Swap, DefectKind::NoStep, DefectKind::Short,
            DefectKind::Fs50, DefectKind::Drift, DefectKind::Psi, DefectKind::RingVar})
        settings.defects.push_back({kind, 0});
    const PipelineOutcome outcome = calibrated(settings);
    if (outcome.error)
        QVERIFY2(isSentence(outcome.error->message), english(outcome.error->message).c_str());
    QCOMPARE(
        static_cast<int>(worstSeverity(allFindings(outcome))), static_cast<int>(Severity::Block));
    QCOMPARE(faultOfJson(outcome), QString());
}

void TestPipelineDefects::rates_100and60megahertz_giveTheSameSensor()
{
    SimulationSettings settings = settingsFor("optic3");
    const SimulatedCapture fast = simulateShots(settings).value();
    settings.sampleRate_Hz = 60e6;
    const SimulatedCapture slow = simulateShots(settings).value();
    CaptureSet mixed = fast.set;
    mixed.shots[1] = slow.set.shots[1];
    ResultCache cache;
    Recipe recipe;
    recipe.uncertainty.monteCarloTrials = kQuickTrials;
    const PipelineOutcome outcome
        = runPipeline(std::make_shared<const CaptureSet>(mixed), recipe, cache);
    QVERIFY2(!outcome.error, outcome.error ? english(outcome.error->message).c_str() : "");
    QVERIFY(!findingsOf(outcome, "CAP-004").empty());
    const Pole *pole = mainPoleOf(outcome);
    constexpr double kFrequencyTolerance = 1e-3; ///< noise 0.2 % of the step leaves 1e-4
    constexpr double kDampingTolerance = 0.03;
    QVERIFY(std::abs(pole->frequency_Hz / 2.33e6 - 1.0) < kFrequencyTolerance);
    QVERIFY(std::abs(pole->dampingRatio / 0.02 - 1.0) < kDampingTolerance);
    QVERIFY(std::abs(*outcome.results.response->sensitivity / 5e-6 - 1.0) < 0.01);
    QCOMPARE(faultOfJson(outcome), QString());
}

void TestPipelineDefects::oneShot_isEnough()
{
    SimulationSettings settings = settingsFor("optic3");
    settings.shots = {ShotLevel::High};
    const PipelineOutcome outcome = calibrated(settings);
    QVERIFY(outcome.results.response);
    QVERIFY(!findingsOf(outcome, "CAP-017").empty());
    QVERIFY(std::abs(mainPoleOf(outcome)->frequency_Hz / 2.33e6 - 1.0) < 1e-3);
    QCOMPARE(faultOfJson(outcome), QString());
    QCOMPARE(written(outcome)["shots"].toArray().size(), 1);
}

void TestPipelineDefects::allShotsExcluded_isOneSentence()
{
    Recipe recipe;
    recipe.import.exclude = {{1, "a"}, {2, "b"}, {3, "c"}};
    const PipelineOutcome outcome = calibrated(settingsFor("optic3"), recipe);
    QVERIFY(outcome.error && isSentence(outcome.error->message));
    QCOMPARE(faultOfJson(outcome, recipe), QString());
}

void TestPipelineDefects::emptySet_isOneSentence()
{
    ResultCache cache;
    const PipelineOutcome outcome = runPipeline(std::make_shared<const CaptureSet>(), {}, cache);
    QVERIFY(outcome.error && isSentence(outcome.error->message));
    QCOMPARE(faultOfJson(outcome), QString());
}

void TestPipelineDefects::order_tooLarge_isOneUsageSentence_data()
{
    QTest::addColumn<int>("order");
    for (const int order : {-1, 0, 121, 1000000000})
        QTest::addRow("%d", order) << order;
}

void TestPipelineDefects::order_tooLarge_isOneUsageSentence()
{
    QFETCH(int, order);
    Recipe recipe;
    recipe.realization.order = Index(order);
    static const auto captures
        = std::make_shared<const CaptureSet>(simulateShots(settingsFor("optic3")).value().set);
    static ResultCache cache; // only the order differs
    const PipelineOutcome outcome = runPipeline(captures, recipe, cache);
    QVERIFY(outcome.error.has_value());
    QCOMPARE(outcome.error->kind, ErrorKind::Usage);
    QCOMPARE(outcome.failedStage, StageId::Model);
    const QString sentence = QString::fromStdString(english(outcome.error->message));
    QVERIFY2(isSentence(outcome.error->message), qPrintable(sentence));
    QVERIFY(sentence.contains(QString::number(order)) && sentence.contains("1 to 120"));
    QCOMPARE(sentence.count('.'), 1);
    QCOMPARE(faultOfJson(outcome, recipe), QString());
}

void TestPipelineDefects::order_thatDiverges_hasNullFitAndAReason()
{
    SimulationSettings settings = settingsFor("optic2");
    settings.noise = 0.05;
    Recipe recipe;
    recipe.input.sampleRate_Hz = 10e6;
    recipe.input.treatment = ResponseTreatment::StepAsImpulse;
    recipe.realization.order = Index(100);
    const PipelineOutcome outcome = calibrated(settings, recipe);
    QVERIFY2(!outcome.error, outcome.error ? english(outcome.error->message).c_str() : "");
    QVERIFY(outcome.results.model->diverges);
    QCOMPARE(faultOfJson(outcome, recipe), QString());
    const QJsonObject model = written(outcome, recipe)["model"].toObject();
    for (const char *key : {"fit_percent", "fit_listing_percent"}) {
        QVERIFY2(model[QLatin1String(key)].isNull(), key);
        QVERIFY2(model[QString(key) + "_reason"].toString().contains("diverges"), key);
    }
    QVERIFY(!findingsOf(outcome, "MOD-001").empty());
}

DYNCAL_TEST(TestPipelineDefects)
#include "tst_pipeline_defects.moc"
