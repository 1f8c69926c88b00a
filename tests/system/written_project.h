// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/dyncal_process.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

/// Of projects that the program writes.
inline constexpr int kCurrentProjectVersion = 2;

/// Writes a project of captures and this recipe.
inline bool writeProject(const QString &project, const QStringList &captures, QJsonObject recipe)
{
    recipe["schema"] = "dyncal-recipe/1";
    QJsonArray entries;
    for (const QString &capture : captures) {
        const QByteArray sha256
            = QCryptographicHash::hash(bytesOf(capture), QCryptographicHash::Sha256).toHex();
        entries.append(QJsonObject{{"path", QFileInfo(project).dir().relativeFilePath(capture)},
            {"sha256", QString(sha256)}});
    }
    const QJsonObject whole{{"format", "dyncal-project"}, {"version", kCurrentProjectVersion},
        {"recipe", recipe}, {"captures", entries}};
    return writeBytes(project, QJsonDocument(whole).toJson());
}
