// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"
#include "core/base/writing/claim_text.h"
#include "core/base/writing/folder_recovery.h"

#include <string>

namespace dyncal {

/// The right to write one file or folder, held until it is destroyed. A claim is a small file
/// ".dyncal-XXXX.claim" beside what is being written, locked as long as its program lives; it names
/// the target and, by its own name, the one temporary file or folder ".dyncal-XXXX" that belongs to
/// it. It appears whole before the temporary one is made and goes after it. So:
/// - a second writer of the same target finds it and is told;
/// - what a killed program left is known by a claim that nobody holds, and nothing else is;
/// - nothing that was planted under a temporary name is followed, opened or removed.
class WriteClaim
{
public:
    /// Claims `target`, a name in `folder` ("." for the folder itself), after completing or
    /// removing what killed programs left: temporary files of any target, but folders of this
    /// target only, as far as `mayWrite` allows their files. `shown` is the path for messages.
    /// Fails (Usage) where the folder cannot be written to or another program writes this target,
    /// (Internal) on a full disk.
    static Result<WriteClaim> take(const std::string &folder, const std::string &target,
        ClaimKind kind, const std::string &shown, const NameRule &mayWrite = {});

    WriteClaim(WriteClaim &&other) noexcept;
    WriteClaim &operator=(WriteClaim &&other) noexcept;
    ~WriteClaim();

    /// The folder that holds the target and the temporary, opened.
    int folder() const { return m_folder.get(); }
    const std::string &folderPath() const { return m_folderPath; }
    /// Gives it up without removing anything: the next write into the folder puts it right.
    void leaveBehind();

    /// Name in that folder for the temporary file or folder; not taken when this was claimed.
    const std::string &temporary() const { return m_temporary; }

private:
    WriteClaim() = default;
    void release();

    FileDescriptor m_folder;
    FileDescriptor m_file; ///< locked
    std::string m_folderPath;
    std::string m_temporary;
};

/// While it lives no other program begins to write in the folder. Invalid (with errno) if the
/// folder cannot be opened or stays locked for more than ten seconds.
class FolderLock
{
public:
    explicit FolderLock(const std::string &folder);
    bool valid() const { return m_folder.valid(); }
    int folder() const { return m_folder.get(); }
    FileDescriptor takeFolder(); ///< unlocked, still open

private:
    FileDescriptor m_folder;
};

/// Completes or removes what killed programs left in a folder, as WriteClaim::take. Fails (Usage)
/// if that is not possible for `target`, or if a living program is writing it.
Result<void> clearClaims(const std::string &folder, const std::string &target,
    const std::string &shown, const NameRule &mayWrite);

/// Whether a living program writes into this (open, locked) folder, not counting the claim of the
/// temporary name `own`.
bool hasLiveClaims(int folder, const std::string &own);

} // namespace dyncal
