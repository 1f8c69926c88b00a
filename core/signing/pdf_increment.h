// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace dyncal {

/// What stands in a PDF beside its signature (ISO 32000-1, 12.8.1).
struct PdfSignatureWords
{
    std::string signer; ///< UTF-8
    std::string utc; ///< ISO 8601
};

/// A PDF with an incremental update behind it that has a signature field, still without the
/// signature. All bytes but those from `holeBegin` to `holeEnd` are what is to be signed.
struct UnsignedIncrement
{
    std::string bytes;
    std::size_t holeBegin = 0; ///< of the '<' of /Contents
    std::size_t holeEnd = 0; ///< behind its '>'
};

/// Bytes of CMS that the update has room for.
inline constexpr std::size_t kCmsRoom = 16384;

/// Appends to a PDF, of which no byte is changed, a signature field with sub-filter
/// ETSI.CAdES.detached (EN 319 142-1): over the place kSignaturePlace (pdf_outline.h), whose words
/// stay to be seen through it, or else on the first page and not to be seen. New revisions of
/// catalog and page, field, its appearance, signature dictionary, classic cross-reference table,
/// trailer. Deterministic. Fails (FileUnreadable) where it is no sound PDF with a classic
/// cross-reference table, is encrypted, or has a signature already.
Result<UnsignedIncrement> withSignatureField(
    const std::string &pdf, const PdfSignatureWords &words);

} // namespace dyncal
