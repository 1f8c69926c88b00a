// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/network_folder.h"

#include <filesystem>
#include <utility>

#include <sys/vfs.h>

namespace dyncal {

std::string networkFileSystem(long type)
{
    // From linux/magic.h and the sources of file systems that are not in it.
    constexpr std::pair<unsigned long, const char *> kTypes[]{{0x6969UL, "NFS"}, {0x517BUL, "SMB"},
        {0xFF534D42UL, "SMB"}, {0xFE534D42UL, "SMB"}, {0x5346414FUL, "AFS"}, {0x6B414653UL, "AFS"},
        {0x73757245UL, "Coda"}, {0x564CUL, "NCP"}, {0x01021997UL, "9P"}, {0x00C36400UL, "Ceph"},
        {0x0BD00BD0UL, "Lustre"}, {0x7461636FUL, "OCFS2"}, {0x01161970UL, "GFS2"},
        {0x47504653UL, "GPFS"}, {0x65735546UL, "FUSE"}};
    constexpr unsigned long kBits = 0xFFFFFFFFUL; // the kernel's field may be signed
    for (const auto &[number, name] : kTypes)
        if ((static_cast<unsigned long>(type) & kBits) == number)
            return name;
    return {};
}

std::string networkFileSystemOf(const std::string &path)
{
    namespace fs = std::filesystem;
    std::error_code unknown;
    fs::path place = fs::absolute(path, unknown);
    while (!fs::exists(place, unknown) && place.has_relative_path())
        place = place.parent_path();
    struct statfs found = {};
    return ::statfs(place.c_str(), &found) == 0 ? networkFileSystem(found.f_type) : std::string();
}

} // namespace dyncal
