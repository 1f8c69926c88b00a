// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/signature_check.h"

#include <string>

namespace dyncal {

/// Signature of a single PDF or XML file, by the ending of its name; of any other file Unsigned.
/// Fails (FileUnreadable) where it cannot be read or is too large to be one.
Result<SignatureCheck> checkFileSignature(const std::string &path, const TrustSettings &trust);

/// Signatures of an issued folder: that of certificate.pdf, and held against it that of dcc.xml
/// where it is there. The status is the graver of both; where only the PDF is signed, as by a seal
/// service, a remark says so.
SignatureCheck checkFolderSignatures(const std::string &folder, const TrustSettings &trust);

} // namespace dyncal
