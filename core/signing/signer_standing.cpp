// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signer_standing.h"

#include "core/base/calendar_date.h"
#include "core/base/content_hash.h"
#include "core/signing/certificate_facts.h"
#include "core/signing/signer_fitness.h"

#include <openssl/pem.h>
#include <openssl/x509_vfy.h>

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Certificates = std::vector<openssl::Certificate>;

openssl::Store storeOf(const std::string &anchors, int purpose)
{
    openssl::Store store(X509_STORE_new());
    for (const openssl::Certificate &one : certificatesIn(anchors))
        X509_STORE_add_cert(store.get(), one.get());
    // A certificate that is named as trusted is so, also where it is no root. Times are judged by
    // judgeSigner(), which can say what is wrong with them.
    X509_STORE_set_flags(store.get(), X509_V_FLAG_PARTIAL_CHAIN | X509_V_FLAG_NO_CHECK_TIME);
    X509_STORE_set_purpose(store.get(), purpose);
    return store;
}

/// The first certificate of a chain that is not valid at a moment; null where all are.
const X509 *invalidAt(const Certificates &chain, const std::string &utc)
{
    const auto found = std::ranges::find_if(
        chain, [&](const openssl::Certificate &one) { return !isValidAt(one.get(), utc); });
    return found == chain.end() ? nullptr : found->get();
}

void remarkUnknown(const TrustSettings &trust, SignatureCheck &check)
{
    check.status = SignatureCheck::Status::UnknownSigner;
    if (trust.anchors.empty())
        check.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "It is signed by “%1”, and whether that is the laboratory is not known: name the certificate that you trust by --trust CA.pem."),
                {check.signer}});
    else
        check.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "It is signed by “%1”, behind whom none of the certificates of --trust stands."),
                {check.signer}});
}

void remarkExpired(const X509 *certificate, const Message &why, SignatureCheck &check)
{
    check.status = SignatureCheck::Status::Expired;
    Message remark{DYNCAL_TEXT("core", "The certificate of “%1” is valid from %2 to %3."),
        {subjectName(certificate), validFrom(certificate), validUntil(certificate)}};
    remark.below.push_back(why);
    check.remarks.push_back(std::move(remark));
}

void judgeTimes(const Certificates &chain, const std::string &now, SignatureCheck &check)
{
    const bool isStamped = !check.stampedUtc.empty();
    const std::string &then = isStamped ? check.stampedUtc : check.signedUtc;
    if (const X509 *bad = then.empty() ? nullptr : invalidAt(chain, then))
        remarkExpired(
            bad, {DYNCAL_TEXT("core", "It was not valid when it signed, at %1."), {then}}, check);
    else if (const X509 *ended = isStamped ? nullptr : invalidAt(chain, now))
        remarkExpired(ended,
            {DYNCAL_TEXT("core",
                 "It is not valid at %1, and no time stamp shows that the signature was made while it was."),
                {now}},
            check);
}

void remarkUse(X509 *signer, SignatureCheck &check)
{
    if (!maySign(signer))
        check.remarks.push_back(
            {DYNCAL_TEXT("core", "The certificate of “%1” is not for signatures (key usage)."),
                {check.signer}});
    if (isForOtherUse(signer))
        check.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "The certificate of “%1” is not for signatures of documents (extended key usage): it is one of a server or of a time-stamping authority."),
                {check.signer}});
}

/// The stamp is put over the signature as soon as it is made.
void remarkMoments(SignatureCheck &check)
{
    constexpr double kMostDays = 1;
    const std::optional<double> signedAt = daysSince1970(check.signedUtc);
    const std::optional<double> stampedAt = daysSince1970(check.stampedUtc);
    if (signedAt && stampedAt && std::abs(*stampedAt - *signedAt) > kMostDays)
        check.remarks.push_back(
            {DYNCAL_TEXT("core",
                 "The signature states that it was made at %1, and its time stamp is of %2: more than a day lies between them."),
                {check.signedUtc, check.stampedUtc}});
}

} // namespace

Certificates certificatesIn(std::string_view pem)
{
    Certificates list;
    const openssl::Bio in = openssl::bioOn(pem);
    while (X509 *one = in ? PEM_read_bio_X509(in.get(), nullptr, nullptr, nullptr) : nullptr)
        list.emplace_back(one);
    ERR_clear_error(); // of the end
    return list;
}

Certificates chainToAnchor(
    X509 *leaf, STACK_OF(X509) * others, const std::string &anchors, int purpose)
{
    Certificates chain;
    const openssl::Store store = storeOf(anchors, purpose);
    const openssl::StoreContext context(X509_STORE_CTX_new());
    if (X509_STORE_CTX_init(context.get(), store.get(), leaf, others) == 1
        && X509_verify_cert(context.get()) == 1) {
        const STACK_OF(X509) *found = X509_STORE_CTX_get0_chain(context.get());
        for (int i = 0; i < sk_X509_num(found); ++i) {
            X509_up_ref(sk_X509_value(found, i));
            chain.emplace_back(sk_X509_value(found, i));
        }
    }
    ERR_clear_error();
    return chain;
}

void judgeSigner(
    X509 *signer, STACK_OF(X509) * others, const TrustSettings &trust, SignatureCheck &check)
{
    check.status = SignatureCheck::Status::Valid;
    check.signer = subjectName(signer);
    check.certificate = sha256Hex(std::string_view(openssl::derOf(signer, &i2d_X509)));
    Certificates chain = chainToAnchor(signer, others, trust.anchors, X509_PURPOSE_ANY);
    const bool isKnown = !chain.empty();
    if (!isKnown) { // its own times are known all the same
        X509_up_ref(signer);
        chain.emplace_back(signer);
    }
    judgeTimes(chain, trust.utc, check);
    if (!isKnown)
        remarkUnknown(trust, check);
    if (std::optional<Message> weakness = weaknessOf(chain)) {
        check.status = SignatureCheck::Status::UnknownSigner;
        check.remarks.push_back(std::move(*weakness));
    }
    remarkUse(signer, check);
    remarkMoments(check);
}

} // namespace dyncal
