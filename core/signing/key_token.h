// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/signing/key_material.h"
#include "core/signing/secret_bytes.h"

namespace dyncal {

/// Whether it is a URI of a token (RFC 7512) rather than a file.
bool isTokenUri(const std::string &source);

/// A source of a key as sentences name it: of a token's URI only what is before its query, where
/// secrets would be.
std::string shownSource(const std::string &source);

/// Fails (Usage) where it holds a PIN, or the name of a file or program that gives one, however the
/// attribute is spelt: it would be seen in lists of processes.
Result<void> checkTokenUri(const std::string &uri);

/// Key and certificate of a token, through OpenSSL's engine pkcs11 (adr/0031). The key stays in the
/// token. Errors as SigningKey::open() has them.
Result<KeyMaterial> keyOfToken(const std::string &uri, const SecretBytes &pin);

} // namespace dyncal
