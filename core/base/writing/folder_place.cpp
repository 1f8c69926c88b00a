// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_place.h"

#include "core/base/writing/file_identity.h"

#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> cannotMake(const std::string &folder, const std::string &reason)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "The folder %1 cannot be made: %2."), {folder, reason}});
}

/// Without the slashes at its end.
fs::path withoutEnd(const std::string &folder)
{
    fs::path path(folder);
    while (!path.has_filename() && path.has_relative_path())
        path = path.parent_path();
    return path;
}

/// Makes what is missing; the deepest last.
std::error_code makeParents(const fs::path &folder, std::vector<std::string> &made)
{
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error))
        return {};
    if (const std::error_code above = makeParents(folder.parent_path(), made))
        return above;
    if (fs::create_directory(folder, error))
        made.push_back(folder.string());
    return error;
}

bool isClaimFolder(const fs::path &parent, const fs::path &folder)
{
    return folder.has_filename() && ::access(parent.c_str(), R_OK | W_OK | X_OK) == 0
        && mountOf(AT_FDCWD, parent.string()) == mountOf(AT_FDCWD, folder.string());
}

} // namespace

Result<FolderPlace> locateFolder(const std::string &folder)
{
    FolderPlace place;
    place.shown = folder;
    std::error_code error;
    const fs::path given = withoutEnd(folder);
    place.exists = fs::is_directory(given, error);
    if (!place.exists && fs::exists(fs::symlink_status(given, error)))
        return cannotMake(folder, "something else has this name");
    if (!place.exists && (given.empty() || given.filename().empty()))
        return cannotMake(folder, "it has no name");
    fs::path real;
    if (place.exists) {
        real = fs::canonical(given, error);
    } else {
        const fs::path parent = fs::absolute(given, error).parent_path();
        if (const std::error_code problem = makeParents(parent, place.made))
            return cannotMake(folder, problem.message());
        real = fs::canonical(parent, error) / given.filename();
    }
    if (error)
        return cannotMake(folder, error.message());
    place.path = real.string();
    const bool isBeside = !place.exists || isClaimFolder(real.parent_path(), real);
    place.claimFolder = isBeside ? real.parent_path().string() : place.path;
    place.claimTarget = isBeside ? real.filename().string() : ".";
    return place;
}

} // namespace dyncal
