// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"

#include <QJsonObject>
#include <QString>

namespace dyncal {

/// The project with its checksums: "sha256" of all it says, and "sha256_of" of each of its parts
/// ("captures", "recipe.window"), so that what changed can be named.
QJsonObject withChecksums(QJsonObject project);

/// PRJ-001 (caution) if the project no longer agrees with its checksums, naming the changed parts;
/// PRJ-002 (info) if it has none, as those of older versions.
Findings checkProject(const QJsonObject &project, const QString &name);

} // namespace dyncal
