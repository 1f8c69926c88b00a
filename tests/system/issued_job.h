// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/short_capture.h"
#include "tests/system/written_project.h"

#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QTemporaryDir>

/// What a certificate must have that no recording says.
inline QJsonObject completeFields()
{
    return {{"laboratory", "Example Laboratory"}, {"laboratory_address", "1 Test Street"},
        {"place", "the laboratory"}, {"customer", "Customer Ltd"},
        {"customer_address", "2 Test Street"}, {"date_received", "2026-01-05"},
        {"date_performed", "2026-01-07"}, {"operator", "A. Berg"}, {"sensor_manufacturer", "Acme"},
        {"sensor_model", "P5"}, {"sensor_serial", "17"}, {"sensor_description", "as received"},
        {"method_id", "M-1"}};
}

/// A recipe that leaves nothing to be asked for: references with certificates, all fields.
inline QJsonObject completeRecipe()
{
    const auto reference = [](const char *quantity, double u) {
        return QJsonObject{{"quantity", quantity}, {"u", u},
            {"certificate", QString("R-") + quantity}, {"due", "2027-01-31"}};
    };
    return {{"schema", "dyncal-recipe/1"},
        {"uncertainty",
            QJsonObject{{"budget",
                            QJsonArray{reference("p1_pa", 50.0), reference("t1_k", 0.2),
                                reference("distance_m", 2e-4), reference("gain_relative", 1e-3),
                                reference("clock_relative", 1e-5)}},
                {"monte_carlo_trials", 1000}}},
        {"certificate", QJsonObject{{"fields", completeFields()}}}};
}

/// A laboratory's folder: recording, project, registry, certificates.
struct IssuedJob
{
    QTemporaryDir folder;

    QString path(const QString &name) const { return folder.filePath(name); }
    QString output() const { return path("certificates"); }
    QString registry() const { return path("registry.sqlite"); }

    /// Copies the recording and writes the project of a recipe.
    bool begin(const QString &recording, const QJsonObject &recipe = completeRecipe()) const
    {
        return QFile::copy(recording, path("shot.h5")) && writeProject(recipe);
    }
    bool writeProject(const QJsonObject &recipe) const
    {
        return ::writeProject(path("job.dyncal"), {path("shot.h5")}, recipe);
    }
    Answer issue(const QStringList &more = {},
        const QStringList &environment = {"SOURCE_DATE_EPOCH=1767225600"}) const
    {
        return runDyncal(QStringList{"issue", path("job.dyncal"), "-o", output(), "--registry",
                             registry(), "--json"}
                + (more.contains("--key") || more.contains("--seal-command")
                        ? QStringList{}
                        : QStringList{"--unsigned"})
                + more,
            environment);
    }
    Answer verify(const QStringList &files) const
    {
        return runDyncal(
            QStringList{"verify"} + files + QStringList{"--registry", registry(), "--json"});
    }
    QJsonArray numbers() const
    {
        return QJsonDocument::fromJson(
            runDyncal({"registry", "list", "--registry", registry(), "--json"}).out)
            .array();
    }
};

/// Bytes of every file below, hidden ones too, by their path from there.
inline QMap<QString, QByteArray> bytesBelow(const QString &folder)
{
    QMap<QString, QByteArray> files;
    for (QDirIterator entry(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         entry.hasNext();) {
        const QString file = entry.next();
        files[QDir(folder).relativeFilePath(file)] = bytesOf(file);
    }
    return files;
}
