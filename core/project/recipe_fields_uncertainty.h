// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/json_codec.h"
#include "core/project/recipe_sections.h"

#include <vector>

namespace dyncal {

/// Internal to core/project: the section "uncertainty".
std::vector<Field<Recipe>> uncertaintySections();

} // namespace dyncal
