// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "registry/cards/card.h"

#include <string>
#include <vector>

namespace dyncal {

/// Cards of one kind as JSON: a list of {"name", "fields": {FIELD: TEXT}}.
std::string cardsJson(const std::vector<Card> &cards);

/// Reads it back; empty fields are left out. Fails (Usage) where it is no such list, and where a
/// name is missing, there twice or longer than kLongestCardName.
Result<std::vector<Card>> parseCardsJson(const std::string &json, const std::string &kind);

} // namespace dyncal
