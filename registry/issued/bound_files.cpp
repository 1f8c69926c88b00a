// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/bound_files.h"

#include "core/base/content_hash.h"
#include "core/base/writing/written_list.h"
#include "registry/issued/issued_files.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dyncal {

std::string boundFilesHash(const std::map<std::string, std::string> &hashes)
{
    constexpr std::array<std::string_view, 4> kLater{
        kIssuedPdf, kAuditFile, kManifest, kWrittenList};
    std::string lines;
    for (const auto &[name, hash] : hashes)
        if (std::ranges::find(kLater, name) == kLater.end())
            lines += name + ' ' + hash + '\n';
    return sha256Hex(std::string_view(lines));
}

} // namespace dyncal
