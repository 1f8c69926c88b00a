// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QtGlobal>

namespace dyncal::trials {

/// How often a test repeats itself: `inSuite` in ./test, `inLongForm` where the environment sets
/// DYNCAL_LONG to anything (`.ci/long`, `ctest --test-dir build-release -C Long -L long -R NAME`).
inline int count(int inSuite, int inLongForm)
{
    return qEnvironmentVariableIsEmpty("DYNCAL_LONG") ? inSuite : inLongForm;
}

} // namespace dyncal::trials
