// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/program_answer.h"

namespace dyncal::testing {

using PythonAnswer = ProgramAnswer;

/// The answer of Debian's own python3 to a call from a test.
inline PythonAnswer python(const QStringList &arguments)
{
    return answerOf("/usr/bin/python3", arguments);
}

/// Whether it has the modules that the comparisons need.
inline bool hasNumericalPython()
{
    return python({"-c", "import numpy, scipy"}).ran;
}

} // namespace dyncal::testing
