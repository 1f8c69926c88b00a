// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Shots and levels one by one, through the whole method.

#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_table.h"
#include "core/results/results_json.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

PipelineOutcome calibrated(const std::string &preset, const std::vector<Defect> &defects = {})
{
    SimulationSettings settings;
    settings.sensor = sensorPreset(preset).value();
    settings.duration_s = 0.004;
    settings.noise = 0.01;
    settings.defects = defects;
    ResultCache cache;
    return runPipeline(std::make_shared<const CaptureSet>(simulateShots(settings).value().set), {},
        cache, StageId::Evidence);
}

bool isTold(const PipelineOutcome &outcome, const char *id)
{
    const Findings findings = allFindings(outcome.results);
    return std::any_of(
        findings.begin(), findings.end(), [&](const Finding &finding) { return finding.id == id; });
}

} // namespace

class TestShotPoles : public QObject
{
    Q_OBJECT

private slots:
    void presets_areHomogeneous_data()
    {
        QTest::addColumn<QString>("preset");
        for (const SensorSpec &sensor : sensorPresets())
            QTest::newRow(sensor.name.c_str()) << QString::fromStdString(sensor.name);
    }
    void presets_areHomogeneous()
    {
        QFETCH(QString, preset);
        const PipelineOutcome outcome = calibrated(preset.toStdString());
        QVERIFY(!outcome.error);
        const ModelAssessment &found = *outcome.results.assessment;
        QVERIFY(found.homogeneity.has_value());
        QVERIFY2(
            found.homogeneity->passed, qPrintable(QString::number(found.homogeneity->probability)));
        QVERIFY(!isTold(outcome, "MOD-010"));
        QCOMPARE(found.perShot.size(), std::size_t(3));
        QCOMPARE(found.perLevel.size(), std::size_t(3));
        QCOMPARE(found.perLevel[0].level, ShotLevel::Low);
        QCOMPARE(found.perLevel[2].level, ShotLevel::High);
        QVERIFY(found.perLevel[0].step < found.perLevel[1].step);
        QVERIFY(found.perLevel[1].step < found.perLevel[2].step);
    }

    void looseMount_isFound_data()
    {
        QTest::addColumn<int>("shot");
        QTest::newRow("middle") << 0;
        QTest::newRow("last") << 3;
    }
    void looseMount_isFound()
    {
        QFETCH(int, shot);
        for (const char *preset : {"optic3", "piezo"}) {
            const PipelineOutcome outcome = calibrated(preset, {{DefectKind::RingVar, shot}});
            QVERIFY(!outcome.error);
            const SensorModel &model = *outcome.results.model;
            const ModelAssessment &found = *outcome.results.assessment;
            qInfo("%s: order %td, probability %g", preset, model.order,
                found.homogeneity ? found.homogeneity->probability : -1.0);
            for (const LevelPole &each : found.perShot)
                qInfo("  %.6g Hz (%.2g), zeta %.4g (%.2g)", each.frequency_Hz, each.u_frequency_Hz,
                    each.dampingRatio, each.u_dampingRatio);
            QVERIFY2(isTold(outcome, "MOD-010"), preset);
            // The mount rings longest, but in one shot only.
            const double f0_Hz = std::string(preset) == "optic3" ? 2.33e6 : 318e3;
            const Pole *main = mainPole(model, &found);
            QVERIFY(main && std::abs(main->frequency_Hz / f0_Hz - 1.0) < 1e-3);
            // Twice the damping in one shot: the sensor's own pole is not shared either.
            QVERIFY2(
                std::ranges::find(main->flags, kShotsDisagreeFlag) != main->flags.end(), preset);
        }
    }

    void results_holdTheTrend()
    {
        const PipelineOutcome outcome = calibrated("optic3");
        const auto json
            = nlohmann::json::parse(resultsJson(outcome, {}, "2026-01-02T03:04:05Z"))["model"];
        QCOMPARE(json["uncertainty_method"].get<std::string>(),
            outcome.results.model->uncertaintyMethod);
        QCOMPARE(json["homogeneity"]["passed"].get<bool>(), true);
        QCOMPARE(json["per_shot"].size(), std::size_t(3));
        const char *levels[] = {"low", "medium", "high"};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto &level = json["per_level"][i];
            QCOMPARE(level["level"].get<std::string>(), std::string(levels[i]));
            QCOMPARE(level["frequency_hz"].get<double>(),
                outcome.results.assessment->perLevel[i].frequency_Hz);
            QVERIFY(level["u_frequency_hz"].get<double>() > 0.0);
            QVERIFY(level["sensitivity"].get<double>() > 0.0);
        }
        // A single resonance: the second-order sensor is what was simulated.
        QCOMPARE(json["second_order"]["describes"].get<bool>(), true);
        QCOMPARE(json["second_order"]["shots"].size(), std::size_t(3));
        QVERIFY(json["poles"][0]["coverage_factor"].get<double>() > 1.95);
    }
};

DYNCAL_TEST(TestShotPoles)
#include "tst_shot_poles.moc"
