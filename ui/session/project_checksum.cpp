// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/project_checksum.h"

#include <QCryptographicHash>
#include <QJsonDocument>

namespace dyncal {

namespace {

constexpr const char *kWhole = "sha256";
constexpr const char *kParts = "sha256_of";
constexpr const char *kRecipe = "recipe";

QString hashOf(const QJsonObject &content)
{
    const QByteArray bytes = QJsonDocument(content).toJson(QJsonDocument::Compact);
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

QJsonObject withoutChecksums(QJsonObject project)
{
    project.remove(kWhole);
    project.remove(kParts);
    return project;
}

/// Every key of the project, and those of the recipe one by one.
QJsonObject partsOf(const QJsonObject &project)
{
    QJsonObject parts;
    const QJsonObject recipe = project[kRecipe].toObject();
    for (auto part = recipe.begin(); part != recipe.end(); ++part)
        parts[QString(kRecipe) + "." + part.key()] = hashOf({{part.key(), part.value()}});
    for (auto part = project.begin(); part != project.end(); ++part)
        if (part.key() != kRecipe || !part.value().isObject())
            parts[part.key()] = hashOf({{part.key(), part.value()}});
    return parts;
}

/// Names of the parts that are not as stated, in order.
QStringList changedParts(const QJsonObject &stated, const QJsonObject &found)
{
    QStringList names;
    for (auto part = stated.begin(); part != stated.end(); ++part)
        if (found[part.key()] != part.value())
            names << part.key();
    for (const QString &name : found.keys())
        if (!stated.contains(name))
            names << name;
    names.sort();
    return names;
}

} // namespace

QJsonObject withChecksums(QJsonObject project)
{
    // Hashed as it will be read back: values that JSON cannot hold change when they are written.
    project = QJsonDocument::fromJson(QJsonDocument(withoutChecksums(project)).toJson()).object();
    const QJsonObject parts = partsOf(project);
    project[kWhole] = hashOf(project);
    project[kParts] = parts;
    return project;
}

Findings checkProject(const QJsonObject &project, const QString &name)
{
    if (!project.contains(kWhole) && !project.contains(kParts))
        return {{.id = "PRJ-002",
            .severity = Severity::Info,
            .message
            = {DYNCAL_TEXT("core",
                   "Project %1 has no checksum (an older version wrote it), so a change of it is not noticed; save it to give it one."),
                {name.toStdString()}}}};
    const QJsonObject content = withoutChecksums(project);
    const QStringList parts = changedParts(project[kParts].toObject(), partsOf(content));
    if (parts.isEmpty() && project[kWhole] == hashOf(content))
        return {};
    const QString what = parts.isEmpty() ? QString(kWhole) : parts.join(", ");
    return {{.id = "PRJ-001",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "Project %1 was changed after the program saved it: %2. If that was not you, take an unchanged copy; otherwise look at what changed and save the project."),
            {name.toStdString(), what.toStdString()}}}};
}

} // namespace dyncal
