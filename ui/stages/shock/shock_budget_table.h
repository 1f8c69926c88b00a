// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_conditions.h"
#include "ui/stages/frame/shown_table.h"

namespace dyncal {

/// What the uncertainty of one shot's step is made of.
ShownTable budgetTable(const ShockConditions &shot);

} // namespace dyncal
