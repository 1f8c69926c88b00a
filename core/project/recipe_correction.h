// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The recipe with one key changed as a finding proposes. An object is merged into the existing
/// one: roles of two channels do not change those of others. Fails (Usage) like parseRecipe if the
/// key does not exist or does not take the value.
Result<Recipe> correctedRecipe(const Recipe &recipe, const Correction &correction);

} // namespace dyncal
