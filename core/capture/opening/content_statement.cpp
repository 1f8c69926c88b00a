// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/content_statement.h"

#include "core/base/content_hash.h"
#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/formats/hdf5/hdf5_content.h"
#include "core/capture/formats/hdf5/hdf5_describe.h"
#include "core/capture/formats/hdf5/hdf5_helper.h"

#include <cstddef>
#include <span>

namespace dyncal {
namespace {

/// Runs in a helper process; empty if the text is no hash.
std::string statedIn(const std::string &path)
{
    const auto tree = describeHdf5(path, Hdf5Depth::RootAttributes, ExpansionBudget(0));
    if (!tree)
        return {};
    const Hdf5Attributes &root = tree->objects.front().attributes;
    const auto stated = root.find(kContentHash);
    const bool isHash = stated != root.end() && isSha256Hex(stated->second.text);
    return isHash ? stated->second.text : std::string();
}

} // namespace

Result<std::vector<std::string>> statedContentHashes(const std::vector<std::string> &paths)
{
    std::vector<std::string> hashes;
    while (hashes.size() < paths.size()) {
        std::string lines;
        const auto tell = [&](GuardedOutput &output) {
            for (std::size_t i = hashes.size(); i < paths.size(); ++i)
                output.write(statedIn(paths[i]) + '\n');
        };
        const auto receive = [&](std::span<const std::byte> bytes) {
            lines.append(reinterpret_cast<const char *>(bytes.data()), bytes.size());
            return lines.size() <= (kSha256Digits + 1) * paths.size();
        };
        const Result<void> done
            = runHdf5Helper(paths[hashes.size()], tell, receive, kDescribingLimits, {});
        std::size_t begin = 0;
        for (std::size_t end; (end = lines.find('\n', begin)) != lines.npos; begin = end + 1)
            hashes.push_back(lines.substr(begin, end - begin));
        if (!done && done.error().kind != ErrorKind::FileUnreadable)
            return tl::unexpected<Error>(done.error());
        if (hashes.size() < paths.size() && !done)
            hashes.emplace_back(); // for the file on which the helper ended
    }
    return hashes;
}

} // namespace dyncal
