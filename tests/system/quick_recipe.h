// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/dyncal_process.h"

#include <QTemporaryDir>

inline constexpr const char *kQuickRecipe = R"({"uncertainty": {"monte_carlo_trials": 100}})";

/// Options of a verb that computes: few trials of the Monte Carlo, which takes nine tenths of a run
/// of a short recording; for tests that ask nothing of it.
inline QStringList quickly()
{
    static const QTemporaryDir folder;
    const QString recipe = folder.filePath("quick.json");
    if (!QFile::exists(recipe) && !writeBytes(recipe, kQuickRecipe))
        qFatal("%s cannot be written.", qPrintable(recipe));
    return {"--recipe", recipe};
}
