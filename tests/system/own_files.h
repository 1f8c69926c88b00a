// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/dyncal_process.h"

#include <QCryptographicHash>
#include <QJsonArray>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace dyncal::testing {

/// Files below `root` that an earlier run listed in one of these folders and that nobody changed
/// since, and the lists: what the next run may replace.
inline std::set<std::string> ownFiles(
    const std::filesystem::path &root, const std::vector<std::string> &folders)
{
    std::set<std::string> own;
    for (const std::string &folder : folders) {
        const std::string base = folder == "." ? std::string() : folder + '/';
        const QString path = QString::fromStdString((root / base).string());
        const QJsonArray files = fileJson(path + "written.json")["files"].toArray();
        for (const auto &file : files) {
            const QString name = file.toObject()["file"].toString();
            const QByteArray hash
                = QCryptographicHash::hash(bytesOf(path + name), QCryptographicHash::Sha256);
            if (file.toObject()["sha256"].toString() == QString(hash.toHex()))
                own.insert(base + name.toStdString());
        }
        if (!files.isEmpty())
            own.insert(base + "written.json");
    }
    return own;
}

} // namespace dyncal::testing
