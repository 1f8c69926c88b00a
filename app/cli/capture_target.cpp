// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/capture_target.h"

#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// Whether the target is the input file itself, or a file in the folder given as input.
bool isInput(const fs::path &target, const std::string &input)
{
    std::error_code error;
    if (fs::equivalent(input, target, error))
        return true;
    for (fs::directory_iterator entry(input, error), end; !error && entry != end;
         entry.increment(error))
        if (std::error_code other; fs::equivalent(entry->path(), target, other))
            return true;
    return false;
}

} // namespace

Result<void> checkCaptureTarget(const CaptureTarget &target, const std::vector<std::string> &inputs)
{
    std::error_code error;
    if (!fs::exists(fs::symlink_status(target.path, error)))
        return {};
    for (const std::string &input : inputs) {
        if (isInput(target.path, input))
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "%1 is one of the inputs and is not overwritten; give the capture another name."),
                    {target.path}});
    }
    if (target.replace)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 exists already and captures are written once; give the capture another name, or say --replace."),
            {target.path}});
}

} // namespace dyncal
