// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "core/results/model_export.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

#include <QDir>
#include <QFile>
#include <QTest>

namespace dyncal::testing {

/// Simulated shots of a sensor, computed up to `last`.
inline CalibrationResults calibratedModel(
    ResponseTreatment treatment, Index order, StageId last = StageId::Response)
{
    SimulationSettings settings;
    settings.sensor = *sensorPreset("optic3");
    settings.duration_s = 0.004;
    Recipe recipe;
    recipe.input.treatment = treatment;
    recipe.realization.order = order;
    ResultCache cache;
    return runPipeline(
        std::make_shared<const CaptureSet>(simulateShots(settings)->set), recipe, cache, last)
        .results;
}

inline void writeModelFiles(const std::vector<ModelFile> &files, const QString &folder)
{
    for (const ModelFile &file : files) {
        QFile target(QDir(folder).filePath(QString::fromStdString(file.name)));
        QVERIFY(target.open(QIODevice::WriteOnly));
        target.write(QByteArray::fromStdString(file.bytes));
    }
}

} // namespace dyncal::testing
