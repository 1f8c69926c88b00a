// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/open_files.h"

#include "core/base/file_descriptor.h"

#include <fcntl.h>

#include <vector>

namespace dyncal {

bool areFilesLeft(int count)
{
    std::vector<FileDescriptor> taken;
    for (int i = 0; i < count; ++i) {
        taken.emplace_back(::open("/dev/null", O_RDONLY | O_CLOEXEC));
        if (!taken.back().valid())
            return false;
    }
    return true;
}

Error tooFewFiles()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "Too few files may be open at once; raise that limit (ulimit -n) to 64 and one for "
             "each recording."),
            {}},
        {}, 0};
}

} // namespace dyncal
