// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/project/recipe.h"

#include <string>

namespace dyncal {

/// Country of the "laboratory" or "customer" as a code of ISO 3166-1: typed as the field
/// "laboratory_country" ..., else as their address has it (countryOf()); kNoCountry where neither
/// says one.
std::string dccCountry(const Recipe &recipe, const std::string &whose);

/// CER-010 for each of both without a country, which a DCC must name (ISO 3166-1; ZZ is a code that
/// stands for none). A caution: the certificate itself needs no country.
Findings countryCautions(const Recipe &recipe);

} // namespace dyncal
