// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/recipe.h"
#include "registry/cards/card.h"

#include <vector>

namespace dyncal {

/// The recipe with what the cards know and nobody has typed; nothing that is typed changes.
/// - Certificate fields: of the laboratory whose name stands in the field "laboratory" (of the only
///   one there is where none does), of the customer named in "customer", of the sensor whose name
///   or whose "sensor_serial" stands in the field "sensor_serial". A card's fields have the names
///   of the certificate's ("laboratory_address", "customer_address", "sensor_model", ...).
/// - Lines of the budget without a certificate: "certificate" and "due" of the reference whose
/// field
///   "quantity" is theirs ("t1_k"), where there is one such reference.
Recipe filledFromCards(Recipe recipe, const std::vector<Card> &cards);

} // namespace dyncal
