// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/signing/secret_bytes.h"

#include <memory>
#include <string>

namespace dyncal {

struct KeyMaterial; ///< key_material.h

/// A private key with the certificate that belongs to it and those above it. Copies share it. The
/// key itself never leaves this room: it is used by cmsOfHash() and signedXml().
class SigningKey
{
public:
    /// `source` is a PKCS#12 file, a PEM file with key and certificates, or "pkcs11:..." (RFC 7512)
    /// of a token's key and certificate; the token's library is the URI's module-path, else
    /// PKCS11_MODULE_PATH of the environment. Fails (FileUnreadable) where a file cannot be read;
    /// (Usage) where the secret is missing or wrong, key and certificate do not belong together,
    /// the key is none of RSA of 2048 bits or more or of the curves P-256, P-384 and P-521, or the
    /// certificate is not for signatures. A token that this process has opened stays open for it. A
    /// URI that holds a PIN is refused: it would be seen in lists of processes.
    static Result<SigningKey> open(const std::string &source, const SecretBytes &secret);

    /// Name of the certificate's subject.
    std::string signer() const;

    /// Fails (Usage) where the certificate is not valid at this moment (ISO 8601, UTC).
    Result<void> checkValidAt(const std::string &utc) const;

    const KeyMaterial &material() const { return *m_material; }

private:
    explicit SigningKey(std::shared_ptr<const KeyMaterial> material)
        : m_material(std::move(material))
    {
    }

    std::shared_ptr<const KeyMaterial> m_material;
};

} // namespace dyncal
