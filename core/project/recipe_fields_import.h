// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/json_codec.h"
#include "core/project/recipe_sections.h"

namespace dyncal {

/// The sections of recipe.json for reading files into captures: the one table for reading, writing,
/// the check of docs/recipe.md and the labels of the window. Internal to core/project.
std::vector<Field<Recipe>> importSections();

} // namespace dyncal
