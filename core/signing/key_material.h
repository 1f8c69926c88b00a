// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/openssl_handles.h"

namespace dyncal {

/// A private key and its certificates, as OpenSSL has them.
struct KeyMaterial
{
    std::shared_ptr<void> token = {}; ///< what must live as long as the key; empty: a file's
    openssl::PrivateKey key = {};
    openssl::Certificate certificate = {};
    std::vector<openssl::Certificate> chain = {}; ///< above it, as the source has them
};

} // namespace dyncal
