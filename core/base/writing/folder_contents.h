// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"
#include "core/base/writing/file_identity.h"
#include "core/base/writing/folder_place.h"
#include "core/base/writing/written_list.h"

#include <functional>
#include <string>
#include <vector>

namespace dyncal {

/// What is to be written where, and what may not be touched.
struct FolderRequest
{
    std::string folder; ///< as given; a link to a folder stands for that folder
    std::string writer; ///< "run", "export": its listed files are replaced
    /// Names that this writer may give to files; a list with other names is not trusted.
    std::function<bool(const std::string &)> mayWrite;
    std::vector<std::string> names; ///< files and folders ("csv/") that it is known to write
    std::vector<std::string> recordings; ///< paths; the folder may hold none of them
    std::vector<std::string> settings; ///< paths of recipe and profile as given; may be empty
    /// Names that any writer of such folders may give; an interrupted write of these is completed.
    std::function<bool(const std::string &)> mayComplete = {}; ///< empty: mayWrite
    /// Asked when all is staged, just before it takes its place: an error leaves all as it was.
    std::function<Result<void>()> mayCommit = {};
};

/// A file that the folder's list names, as it is now.
struct OwnFile
{
    WrittenFile listed;
    FileIdentity identity;
    mode_t mode = 0; ///< its permissions, which the file that replaces it keeps
};

/// What an existing folder holds.
struct FolderContents
{
    FileDescriptor folder; ///< open; invalid where there is no folder yet
    std::vector<OwnFile> own; ///< of this writer: unchanged, there
    WrittenList others; ///< listed by other writers
    std::optional<FileIdentity> list; ///< of written.json
    std::string listSha256;
    mode_t listMode = 0; ///< its permissions
};

/// Looks at the folder; fails as FolderWrite::begin. `names` as in FolderRequest. The folder is
/// reached from `claimFolder`, the claim's open folder, as the path may lead elsewhere by now.
Result<FolderContents> inspectFolder(const FolderPlace &place, int claimFolder,
    const FolderRequest &request, const std::vector<std::string> &names);

} // namespace dyncal
