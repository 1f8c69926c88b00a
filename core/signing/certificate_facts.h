// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/signing/openssl_handles.h"

#include <string>

namespace dyncal {

/// Name of whom a certificate is for: its common name, else its organisation, else the whole
/// subject; UTF-8, as it stands there.
std::string subjectName(const X509 *certificate);

/// A moment as ISO 8601 writes it, "2026-01-31T04:23:11Z", which compares as text. Empty where it
/// is none.
std::string utcText(const ASN1_TIME *time);

std::string validFrom(const X509 *certificate);
std::string validUntil(const X509 *certificate);

/// Whether a moment (ISO 8601, UTC) lies within the certificate's validity, ends included.
bool isValidAt(const X509 *certificate, const std::string &utc);

/// Whether the certificate may stand behind signatures of documents: its key usage, where it states
/// one, has digitalSignature or nonRepudiation (RFC 5280, 4.2.1.3).
bool maySign(X509 *certificate);

/// Whether it is for other things alone: its extended key usage, where it states one, names only
/// servers of the web, time stamps and answers on revocation (RFC 5280, 4.2.1.12).
bool isForOtherUse(const X509 *certificate);

} // namespace dyncal
