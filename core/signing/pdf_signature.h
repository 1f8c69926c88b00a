// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/pdf_increment.h"
#include "core/signing/signature_check.h"

#include <functional>
#include <string>
#include <string_view>

namespace dyncal {

/// A detached CMS (DER) over content with this SHA-256 (64 hexadecimal digits).
using CmsOfHash = std::function<Result<std::string>(const std::string &sha256)>;

/// Signs a PDF by an incremental update behind it (withSignatureField), of which no byte but the
/// hole of the signature is left unsigned. Fails as withSignatureField() and `cmsOf` do, and
/// (DataBlocked) where the CMS has no room (kCmsRoom); (FileUnreadable) also where a text in it
/// looks like a signature.
Result<std::string> signedPdf(
    const std::string &pdf, const PdfSignatureWords &words, const CmsOfHash &cmsOf);

/// Holds the signature of a PDF against the file. It must be the only one, cover all of the file
/// but its own hole, which holds the CMS and zeros behind it, and be the one that readers show
/// (faultOfField). A PDF without any trace of a signature is Unsigned. Not looked at: whether
/// certificates were revoked.
SignatureCheck checkPdfSignature(std::string_view pdf, const TrustSettings &trust);

/// Bytes of the PDF before its signature's update, which are the same whoever signs and whenever;
/// the whole PDF where it is not signed.
std::string_view unsignedRevision(std::string_view pdf);

} // namespace dyncal
