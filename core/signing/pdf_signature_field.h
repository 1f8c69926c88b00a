// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// A signature as the bytes of a PDF show it: what it covers, without its hole.
struct PdfSignaturePlace
{
    std::size_t holeBegin = 0; ///< of the '<' of /Contents
    std::size_t holeEnd = 0; ///< behind its '>'
    std::size_t end = 0; ///< of what is covered
};

/// More signatures than the one of a certificate.
Message severalSignatures();

/// Whether the signature at this place is the one that readers of the PDF show (ISO 32000-1, 12.7.4
/// and 12.8.1): the value of the one signature field in the form of the catalog that the last
/// trailer names, with this range and these contents; and no other signature beside it, which an
/// update could have brought. A sentence says why not. Reads with libqpdf, repairs nothing.
std::optional<Message> faultOfField(std::string_view pdf, const PdfSignaturePlace &place);

} // namespace dyncal
