// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/signing/awaited_bytes.h"

#include <stop_token>
#include <string>

namespace dyncal {

/// Sends bytes by a POST of HTTP/1.0 to "http://HOST[:PORT][/PATH]" and returns the body of the
/// answer. No redirection is followed. Fails (Usage) for another kind of address; (FileUnreadable)
/// where nobody answers within the limits, or with another status than 200, or not whole (another
/// Content-Length than bytes came, a Transfer-Encoding); (Cancelled) on request.
/// Only the look-up of the name is not under the time limit, but under the system's.
Result<std::string> postedTo(const std::string &url, const std::string &contentType,
    const std::string &bytes, const std::stop_token &stop, const AnswerLimits &limits = {});

/// Whether postedTo() would take the address. Fails (Usage) where not.
Result<void> checkHttpAddress(const std::string &url);

} // namespace dyncal
