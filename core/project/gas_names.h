// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_settings.h"

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// The gases that a recipe may name, as ideal gases of constant heat capacity: "air" as in the
/// thesis, table 4.1 (gamma of the real gas at 1 atm); "n2", "he", "ar" with the heat capacity
/// ratio of kinetic theory (7/5, 5/3) and the molar mass of the IUPAC standard atomic weights.
/// "n2" is given the value 1.400 although the real gas has 1.401 at room conditions.
const std::vector<std::pair<std::string, GasSettings>> &namedGases();

} // namespace dyncal
