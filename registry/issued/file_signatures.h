// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/signature_check.h"

#include <string>

namespace dyncal {

/// What a single file could be signed as.
enum class SignedKind { None, Pdf, Xml };

/// A PDF or a DCC by its first 1024 bytes, whatever it is called; else by the ending of its name,
/// ".pdf" or ".xml" in letters of any size.
SignedKind signedKindOf(const std::string &path);

/// Signature of a single PDF or XML file (signedKindOf); of any other file Unsigned.
/// Fails (FileUnreadable) where it cannot be read or is too large to be one.
Result<SignatureCheck> checkFileSignature(const std::string &path, const TrustSettings &trust);

/// Signatures of an issued folder: that of certificate.pdf, and held against it that of dcc.xml
/// where it is there. The status is the graver of both, and Changed where two certificates signed
/// them; where only the PDF is signed, as by a seal service, a remark says so.
SignatureCheck checkFolderSignatures(const std::string &folder, const TrustSettings &trust);

} // namespace dyncal
