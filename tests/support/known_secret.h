// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signing/secret_bytes.h"

#include <string_view>

#include <unistd.h>

namespace dyncal::testing {

/// A passphrase as --pin-fd gives it: read from a pipe; none of an empty text.
inline SecretBytes secretOf(std::string_view text)
{
    int ends[2] = {-1, -1};
    if (text.empty() || ::pipe(ends) != 0)
        return {};
    const bool isWritten
        = ::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::close(ends[1]);
    Result<SecretBytes> secret = SecretBytes::readFrom(ends[0]);
    ::close(ends[0]);
    return isWritten && secret ? std::move(*secret) : SecretBytes();
}

} // namespace dyncal::testing
