// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <functional>
#include <string>

namespace dyncal {

/// Sends a request to a time-stamping authority and returns its reply, both DER (RFC 3161, 2.4).
using AskAuthority = std::function<Result<std::string>(const std::string &request)>;

/// Puts a time stamp over the signature in a detached CMS (DER) among its unsigned attributes
/// (RFC 3161, appendix A): from then on others can see that it was made before that moment. The
/// request has SHA-256 and asks for the authority's certificate; its nonce follows from the
/// signature, so that there is no random part in it. Fails as `ask` does, and (DataBlocked) where
/// the reply is no time stamp over this signature.
Result<std::string> withTimeStamp(const std::string &cms, const AskAuthority &ask);

} // namespace dyncal
