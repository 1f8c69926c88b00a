// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_table.h"
#include "core/results/method_versions.h"
#include "core/results/results_json.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QtTest>

using namespace dyncal;

/// One version for every stage, the same as results.json states.
class TestMethodVersions : public QObject
{
    Q_OBJECT

private slots:
    void everyStage_hasOne()
    {
        const MethodVersions versions = methodVersions();
        QCOMPARE(versions.size(), static_cast<std::size_t>(kStageCount));
        QCOMPARE(versions.at("monte_carlo"), stageOf(StageId::MonteCarlo).method);
        QCOMPARE(versions.at("model"), stageOf(StageId::Model).method);
    }

    void results_stateTheSame()
    {
        const auto json = nlohmann::json::parse(resultsJson({}, {}, "2026-01-01T00:00:00Z"));
        QCOMPARE(json.at("software").at("method").get<MethodVersions>(), methodVersions());
    }
};

DYNCAL_TEST(TestMethodVersions)
#include "tst_method_versions.moc"
