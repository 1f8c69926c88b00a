// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

namespace dyncal {

/// Whether so many more files may be open at once.
bool areFilesLeft(int count);

/// Internal: says what to do where they are not.
Error tooFewFiles();

} // namespace dyncal
