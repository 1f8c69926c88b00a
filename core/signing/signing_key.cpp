// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signing_key.h"

#include "core/signing/certificate_facts.h"
#include "core/signing/key_file.h"
#include "core/signing/key_token.h"

namespace dyncal {
namespace {

constexpr int kLeastRsaBits = 2048;

bool isStrongKey(const EVP_PKEY *key)
{
    const int kind = EVP_PKEY_get_base_id(key);
    return kind == EVP_PKEY_EC || (kind == EVP_PKEY_RSA && EVP_PKEY_get_bits(key) >= kLeastRsaBits);
}

Result<void> checkKey(const KeyMaterial &state, const std::string &source)
{
    const bool isPair = X509_check_private_key(state.certificate.get(), state.key.get()) == 1;
    ERR_clear_error();
    if (!isPair)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The certificate in %1 (%2) does not belong to the private key there; give the certificate that was made for this key."),
                {source, subjectName(state.certificate.get())}});
    if (!isStrongKey(state.key.get()))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The key in %1 is none to sign certificates with; take an RSA key of %2 bits or more, or one of an elliptic curve."),
                {source, std::to_string(kLeastRsaBits)}});
    if (!maySign(state.certificate.get()))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The certificate of %1 is not for signatures: its key usage has neither digitalSignature nor nonRepudiation; take one that has."),
                {subjectName(state.certificate.get())}});
    return {};
}

} // namespace

Result<SigningKey> SigningKey::open(const std::string &source, const SecretBytes &secret)
{
    Result<KeyMaterial> state
        = isTokenUri(source) ? keyOfToken(source, secret) : keyOfFile(source, secret);
    if (!state)
        return tl::unexpected<Error>(state.error());
    if (const Result<void> fit = checkKey(*state, source); !fit)
        return tl::unexpected<Error>(fit.error());
    return SigningKey(std::make_shared<const KeyMaterial>(std::move(*state)));
}

std::string SigningKey::signer() const
{
    return subjectName(m_material->certificate.get());
}

Result<void> SigningKey::checkValidAt(const std::string &utc) const
{
    const X509 *certificate = m_material->certificate.get();
    if (isValidAt(certificate, utc))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The certificate of %1 is valid from %2 to %3 and not at %4, when it would sign; take one that is valid."),
            {signer(), validFrom(certificate), validUntil(certificate), utc}});
}

} // namespace dyncal
