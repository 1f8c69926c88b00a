// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signing_key.h"

#include "core/signing/certificate_facts.h"
#include "core/signing/key_file.h"
#include "core/signing/key_token.h"
#include "core/signing/signer_fitness.h"

namespace dyncal {
namespace {

Result<void> checkKey(const KeyMaterial &state, const std::string &source)
{
    const bool isPair = X509_check_private_key(state.certificate.get(), state.key.get()) == 1;
    ERR_clear_error();
    if (!isPair)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The certificate in %1 (%2) does not belong to the private key there; give the certificate that was made for this key."),
                {source, subjectName(state.certificate.get())}});
    return checkFitToSign(state.certificate.get(), source);
}

} // namespace

Result<SigningKey> SigningKey::open(const std::string &source, const SecretBytes &secret)
{
    Result<KeyMaterial> state
        = isTokenUri(source) ? keyOfToken(source, secret) : keyOfFile(source, secret);
    if (!state)
        return tl::unexpected<Error>(state.error());
    if (const Result<void> fit = checkKey(*state, shownSource(source)); !fit)
        return tl::unexpected<Error>(fit.error());
    return SigningKey(std::make_shared<const KeyMaterial>(std::move(*state)));
}

std::string SigningKey::signer() const
{
    return subjectName(m_material->certificate.get());
}

Result<void> SigningKey::checkValidAt(const std::string &utc) const
{
    return checkSignerValidAt(m_material->certificate.get(), utc);
}

} // namespace dyncal
