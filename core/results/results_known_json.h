// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/json_record.h"
#include "core/uncertainty/known_value.h"

#include <vector>

namespace dyncal {

/// Key `known` of a section `response`: values of other calibrations beside this one's, in the
/// recipe's order; an empty list where the recipe has none.
JsonRecord::Json knownJson(const std::vector<KnownValue> &known);

} // namespace dyncal
