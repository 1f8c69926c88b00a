// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// For the sources of this room that know libxml2.

#include "core/signing/key_material.h"
#include "core/signing/xml_document.h"

namespace dyncal {

/// The element SignedInfo over a document whose canonical form has this SHA-256 (bytes), as
/// exclusive canonicalisation writes it: these very bytes are what the key signs.
std::string canonicalSignedInfo(std::string_view digest, bool isRsa);

/// The whole element Signature, with the key's certificate and those above it.
std::string signatureElement(
    const std::string &signedInfo, std::string_view signature, const KeyMaterial &state);

/// Where the end tag of the root begins; 0 where there is none.
std::size_t endOfRoot(const std::string &xml, const xmlNode *root);

} // namespace dyncal
