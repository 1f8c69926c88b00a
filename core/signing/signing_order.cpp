// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signing_order.h"

#include "core/signing/cms_signature.h"
#include "core/signing/http_post.h"
#include "core/signing/pdf_signature.h"
#include "core/signing/seal_command.h"
#include "core/signing/time_stamp.h"
#include "core/signing/xml_signing.h"

namespace dyncal {
namespace {

/// The seal of a service whose certificate may sign now: what a key's must be before it is opened.
Result<std::string> sealOf(const std::string &sha256, const SigningOrder &order,
    const std::string &utc, const std::stop_token &stop)
{
    const Result<std::string> cms = sealedBy(order.sealCommand, sha256, stop);
    if (cms)
        if (const Result<void> fit
            = checkSignerOfCms(*cms, wordsOfCommand(order.sealCommand)->front(), utc);
            !fit)
            return tl::unexpected<Error>(fit.error());
    return cms;
}

Result<std::string> cmsOf(const std::string &sha256, const SigningOrder &order,
    const std::string &utc, const std::stop_token &stop)
{
    const Result<std::string> cms
        = order.key ? cmsOfHash(sha256, *order.key) : sealOf(sha256, order, utc, stop);
    if (!cms || order.authority.empty())
        return cms;
    return withTimeStamp(*cms, [&](const std::string &request) {
        return postedTo(order.authority, "application/timestamp-query", request, stop);
    });
}

} // namespace

std::string signerOf(const SigningOrder &order)
{
    return order.key ? order.key->signer() : std::string();
}

Result<std::string> signedDcc(const std::string &xml, const SigningOrder &order)
{
    return order.key ? signedXml(xml, *order.key) : xml;
}

Result<std::string> signedCertificate(const std::string &pdf, const SigningOrder &order,
    const std::string &utc, const std::stop_token &stop)
{
    if (!order.isSigned())
        return pdf;
    if (order.key)
        if (const Result<void> valid = order.key->checkValidAt(utc); !valid)
            return tl::unexpected<Error>(valid.error());
    const PdfSignatureWords words{order.key ? signerOf(order) : kSealName, utc};
    return signedPdf(
        pdf, words, [&](const std::string &sha256) { return cmsOf(sha256, order, utc, stop); });
}

} // namespace dyncal
