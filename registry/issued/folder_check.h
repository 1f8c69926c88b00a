// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/certificates/certificate_register.h"
#include "registry/issued/issued_files.h"

#include <optional>

namespace dyncal {

/// What an issued folder says, held against itself and against the registry.
struct FolderCheck
{
    std::optional<Message> firstDifference; ///< empty: everything fits
    bool isMissing = false; ///< the difference is a file that is not there
    std::vector<Message> remarks; ///< withdrawn, replaced, not looked up in a registry
    Index number = 0;
    std::optional<CertificateState> state; ///< by the registry; empty without one
    Index entries = 0; ///< of audit.jsonl
    std::string head; ///< of the audit trail before issuing
};

/// Holds against each other, in this order: manifest.json and every file beside it (none missing,
/// changed or added); the chain in audit.jsonl and the head in the manifest; recipe, recordings and
/// number in project, recipe.json and results.json; number, head and hash of results.json in the
/// PDF; and, with a registry, its row and its audit trail. Fails (FileUnreadable) where there is no
/// manifest that can be read, and as the registry does.
Result<FolderCheck> checkIssuedFolder(const std::string &folder, CertificateRegister *registry);

/// The number whose certificate has a file of this hash by the registry; empty where none has.
Result<std::optional<CertificateRecord>> certificateWithFile(
    CertificateRegister &registry, const std::string &sha256);

/// Remarks on what has become of a certificate; empty while it is in force.
std::vector<Message> remarksOn(const CertificateRecord &record);

} // namespace dyncal
