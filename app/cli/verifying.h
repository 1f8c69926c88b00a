// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "app/cli/verified.h"
#include "core/signing/signature_check.h"
#include "registry/certificates/certificate_register.h"

namespace dyncal {

/// What is held against what.
struct VerifyOptions
{
    std::vector<std::string> files; ///< files, folders and addresses of registries
    std::string registry; ///< address; empty: none
    std::vector<std::string> recordings; ///< folders in which the recordings are looked for
    TrustSettings trust; ///< against which signatures are held
};

/// Verifies every file and every issued folder in or below a folder; what cannot be read has that
/// status. Fails only where the registry that is named cannot be opened, and on request.
Result<std::vector<Verified>> verifyAll(const VerifyOptions &options);

} // namespace dyncal
