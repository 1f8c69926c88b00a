// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "registry/certificates/certificate_register.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace dyncal {

/// --registry FILE|postgresql://...
void declareRegistry(CLI::App &verb, std::string &registry);

/// --reason TEXT, which is needed, and --by NAME, else the name of the account.
void declareReason(CLI::App &verb, std::string &by, std::string &reason);

/// What `change` makes of a certificate in the registry, opened to write, at this moment (UTC).
/// Fails as the clock, the opening and `change` do.
Result<CertificateRecord> changedNow(const std::string &registry,
    const std::function<Result<CertificateRecord>(CertificateRegister &, const std::string &)>
        &change);

} // namespace dyncal
