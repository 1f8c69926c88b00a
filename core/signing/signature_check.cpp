// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/signature_check.h"

#include "core/signing/signer_standing.h"

#include <array>
#include <fstream>
#include <iterator>

namespace dyncal {

Result<std::string> readAnchors(const std::string &path)
{
    std::ifstream in(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(in), {});
    if (!certificatesIn(text).empty())
        return text;
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 holds no certificate that could be trusted; give a file in PEM form, with -----BEGIN CERTIFICATE-----."),
            {path}});
}

const char *signatureStatusName(SignatureCheck::Status status)
{
    constexpr std::array<const char *, 5> kNames{
        "valid", "unsigned", "changed", "unknown-signer", "expired"};
    return kNames[static_cast<std::size_t>(status)];
}

} // namespace dyncal
