// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/check_settings.h"
#include "core/capture/import_settings.h"
#include "core/project/json_codec.h"

namespace dyncal {

/// The keys of recipe.json for reading files into captures: the one table for reading, writing and
/// the check of docs/recipe.md. Internal to core/project.
Codec<ImportSettings> importCodec();
Codec<CheckSettings> checksCodec();

} // namespace dyncal
