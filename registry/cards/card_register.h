// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/cards/card.h"
#include "registry/store/registry_database.h"

#include "core/base/index.h"

#include <vector>

namespace dyncal {

/// Cards of a kind, by name. Fails (FileUnreadable) on a row that is none, and as the database
/// does.
Result<std::vector<Card>> cardsOf(RegistryDatabase &database, const std::string &kind);

/// The card of that name; empty where there is none.
Result<std::optional<Card>> findCard(
    RegistryDatabase &database, const std::string &kind, const std::string &name);

/// All cards of the registry at an address, to fill certificates from; none where there is no
/// registry yet. Nothing is made or changed.
Result<std::vector<Card>> cardsAt(const std::string &address);

/// Puts cards in, new or in the place of those of the same name, as one transaction; each that
/// changes something has its entry in the audit trail. Returns how many those were.
Result<Index> putCards(RegistryDatabase &database, const std::vector<Card> &cards,
    const std::string &who, const std::string &reason, const std::string &utc);

} // namespace dyncal
