// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/python_answer.h"

#include <QString>

/// "" where every number of the certificate in the folder stands in its DCC, by
/// tests/audit/dcc_numbers.py; else what that script says.
inline QByteArray missingDccNumbers(const QString &folder, const QString &language = "en")
{
    const auto answer = dyncal::testing::python(
        {qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/tests/audit/dcc_numbers.py", folder,
            language});
    return answer.ran ? QByteArray() : answer.out + answer.err;
}
