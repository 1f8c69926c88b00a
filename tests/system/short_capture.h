// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/dyncal_process.h"

/// Simulates one shot of 3 ms, quickly read and fitted; false, with a warning, if the program
/// failed.
inline bool simulateShortCapture(const QString &path, int seed)
{
    const Answer answer = runDyncal(
        {"simulate", "-o", path, "--preset", "piezo", "--duration-s", "0.003", "--sample-rate-hz",
            "1e7", "--shots", "low", "--seed", QString::number(seed)},
        {"SOURCE_DATE_EPOCH=1700000000"});
    if (answer.exitCode != 0)
        qWarning("%s", answer.err.constData());
    return answer.exitCode == 0;
}
