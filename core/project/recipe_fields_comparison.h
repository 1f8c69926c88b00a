// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/json_codec.h"
#include "core/project/recipe_sections.h"

namespace dyncal {

/// The section of recipe.json for a reference transducer, as recipe_fields_import.h.
std::vector<Field<Recipe>> comparisonSections();

} // namespace dyncal
