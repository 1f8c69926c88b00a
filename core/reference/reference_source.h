// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/reference/comparison_settings.h"

#include <string>

namespace dyncal {

/// Reads the file of settings.source, relative to `folder` ("" = where the program runs), into
/// settings.loaded; that stays empty without a source, where the file cannot be read and where it
/// is larger than the 16 MiB that any certificate needs.
void loadReference(const std::string &folder, ComparisonSettings &settings);

} // namespace dyncal
