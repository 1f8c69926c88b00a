// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_settings.h"

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// The gases that a recipe may name by one word, with constant heat capacity (constants and their
/// sources: knownGases()); "humid-air" takes gamma and speed of sound from Cramer's formula.
const std::vector<std::pair<std::string, GasSettings>> &namedGases();

} // namespace dyncal
