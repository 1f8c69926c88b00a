// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

namespace dyncal {

/// Whether `count` more files can be open at once.
bool areFilesLeft(int count);

/// The error (Internal) where they cannot; it says what to do.
Error tooFewFiles();

} // namespace dyncal
