// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/dyncal_process.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

/// Writes a project of the first shot of a capture beside it, with this recipe.
inline bool writeProject(const QString &project, const QString &capture, QJsonObject recipe)
{
    recipe["schema"] = "dyncal-recipe/1";
    const QJsonObject info = runDyncal({"info", capture, "--json"}).json();
    const QJsonObject entry{{"path", QFileInfo(project).dir().relativeFilePath(capture)},
        {"sha256", info["files"][0]["sha256"]}, {"shots", QJsonArray{1}}};
    const QJsonObject whole{{"format", "dyncal-project"}, {"version", 1}, {"recipe", recipe},
        {"captures", QJsonArray{entry}}};
    return writeBytes(project, QJsonDocument(whole).toJson());
}
