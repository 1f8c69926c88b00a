// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/bound_files.h"

#include "core/base/content_hash.h"
#include "core/base/writing/written_list.h"
#include "core/dcc/dcc_document.h"
#include "registry/issued/issued_files.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dyncal {

std::string boundFilesHash(const std::map<std::string, std::string> &hashes)
{
    constexpr std::array<std::string_view, 5> kBoundOtherwise{
        kIssuedPdf, kDccFile, kAuditFile, kManifest, kWrittenList};
    std::string lines;
    for (const auto &[name, hash] : hashes)
        if (std::ranges::find(kBoundOtherwise, name) == kBoundOtherwise.end())
            lines.append(name).append(1, ' ').append(hash).append(1, '\n');
    return sha256Hex(std::string_view(lines));
}

} // namespace dyncal
