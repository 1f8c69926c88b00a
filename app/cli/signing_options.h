// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/signing_order.h"

#include <CLI/CLI.hpp>

#include <string>

namespace dyncal {

/// Who signs a certificate, as the command line says it.
struct SigningOptions
{
    std::string key; ///< FILE.p12, FILE.pem or pkcs11:URI
    int pinDescriptor = -1; ///< of --pin-fd; -1: no PIN or passphrase is given
    std::string sealCommand;
    std::string authority; ///< of --tsa
    bool isUnsigned = false;
};

/// --key, --pin-fd, --seal-command, --tsa and --unsigned.
void declareSigning(CLI::App &verb, SigningOptions &options);

/// Opens the key, reading the PIN and closing its descriptor; from then on no memory of this
/// process gets into a core file. Fails (Usage) unless exactly one of key, seal command and
/// --unsigned is given, with options that belong together, and as SigningKey::open() does; also
/// where the certificate is not valid at `utc`.
Result<SigningOrder> signingOrder(const SigningOptions &options, const std::string &utc);

} // namespace dyncal
