// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/writing/folder_contents.h"
#include "core/base/writing/folder_place.h"
#include "core/base/writing/folder_plan.h"
#include "core/base/writing/write_claim.h"
#include "core/base/writing/written_list.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// One file to be written, its bytes owned by the caller.
struct FolderFile
{
    std::string name; ///< relative to the folder, '/' between its parts
    std::string_view bytes;
};

/// A set of files written into a folder as one transaction: all of them take the place of those
/// that the same kind of writer listed there before (written.json), or nothing changes. Files that
/// are not listed, or were changed since, are never replaced or removed.
///
/// The new folder is built beside the old one, with second names (hard links) for what is kept,
/// flushed, and the two are exchanged in one step. Where that is not possible (the parent cannot be
/// written to, a mount point, the working folder, folders of somebody else's inside, a file system
/// without the exchange) the files are moved one by one by a plan that is on disk before; a program
/// killed within it leaves a plan that the next write into the folder completes. A folder that is
/// renamed, moved or replaced meanwhile is left as it is, and so is what has its name then.
class FolderWrite
{
public:
    /// Claims the folder, which need not exist, and looks whether it may be written to: before the
    /// work whose results are to be kept there. Fails (Usage), naming the file, if the folder holds
    /// a recording of the run, a changed file, or something that is not ours under one of the
    /// names; if another program is writing there; if it cannot be written to.
    static Result<FolderWrite> begin(const FolderRequest &request);

    FolderWrite(FolderWrite &&) noexcept = default;
    FolderWrite &operator=(FolderWrite &&) = delete;
    ~FolderWrite();

    /// As given, for messages and as the beginning of the paths in it.
    const std::string &folder() const { return m_place.shown; }

    /// Writes the files and the list, once; the claim ends with it, however it went. Asked to stop
    /// before the exchange it leaves everything as it was (Cancelled). Fails as begin(), as
    /// FolderRequest::mayCommit, and (Internal) where writing fails; nothing changed then.
    Result<void> commit(const std::vector<FolderFile> &files, const JobControl &control = {});

private:
    FolderWrite(FolderRequest request, FolderPlace place, WriteClaim claim);
    Result<void> stage(const std::vector<FolderFile> &files, const FolderContents &before,
        const JobControl &control);
    Result<void> commitClaimed(const std::vector<FolderFile> &files, const JobControl &control);
    Result<void> placeNewFolder();
    void release();
    bool isStillThere(int folder) const;
    Result<void> replaceFolder(const FolderContents &before);
    Result<void> finishExchange(const FolderContents &before, const FolderPlan &plan);
    Result<void> moveFiles(const FolderContents &before, const FolderPlan &plan);

    FolderRequest m_request;
    FolderPlace m_place;
    std::optional<WriteClaim> m_claim;
    FileDescriptor m_staging; ///< the temporary folder of the claim
    FileDescriptor m_tree; ///< in it: the folder as it is to be
    WrittenList m_placed; ///< what is in it, the list itself last
    bool m_mustStay = false; ///< the staging folder holds what the next write has to put right
};

} // namespace dyncal
