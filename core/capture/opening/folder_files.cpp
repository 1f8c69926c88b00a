// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/folder_files.h"

#include "core/capture/natural_order.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

} // namespace

Result<std::vector<std::string>> filesOfFolder(const std::string &folder)
{
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const bool hidden = entry->path().filename().string().starts_with('.');
        const bool companion = entry->path().extension() == ".tdms_index"; // one per TDMS file
        std::error_code unknown;
        if (!hidden && !companion && entry->is_regular_file(unknown))
            files.push_back(entry->path().string());
    }
    if (error)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "The folder %1 cannot be listed; check that you may read it."),
                {folder}},
            "CAP-018");
    std::ranges::sort(files, naturalLess);
    return files;
}

} // namespace dyncal
