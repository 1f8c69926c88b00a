// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/certificates/certificate_register.h"

#include <optional>

namespace dyncal {

/// What a registry says of itself, held against itself.
struct RegistryCheck
{
    std::optional<Message> firstDifference; ///< empty: it is whole
    Index entries = 0; ///< of the audit trail
    Index anchored = 0; ///< of these, how many stand behind the last issued certificate: entries
                        ///< after it could be cut off unseen
    std::string head; ///< SHA-256 of the last entry; empty: none
};

/// Whether the database is undamaged, the chain of the audit trail unbroken, every row what the
/// last entry about it says (each entry beginning where the one before ended), every number from 1
/// to the counter there, and nothing else in the tables. Fails as RegistryDatabase does.
Result<RegistryCheck> checkRegistry(CertificateRegister &registry);

} // namespace dyncal
