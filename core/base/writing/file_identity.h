// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace dyncal {

enum class FileType { Regular, Folder, Other };

/// Which file a name stands for and in what state, without following a link.
struct FileIdentity
{
    FileType type = FileType::Other;
    dev_t device = 0;
    ino_t inode = 0;
    std::uint64_t bytes = 0;
    std::int64_t modified_ns = 0;

    bool isSameFile(const FileIdentity &other) const
    {
        return device == other.device && inode == other.inode;
    }
    bool operator==(const FileIdentity &) const = default;
};

/// Empty if nothing has the name (relative to the open `folder`, '/' between its parts) or a part
/// of it is a link.
std::optional<FileIdentity> identityOf(int folder, const std::string &name);

/// Which mount a name lies on: files cannot be moved from one to another.
std::uint64_t mountOf(int folder, const std::string &name);

/// Whether the name stands for this open folder.
bool isFolderAt(int folder, const std::string &name, int opened);

/// Whether the file or folder of that name belongs to the user who runs the program.
bool isOwnedByUser(int folder, const std::string &name);

/// SHA-256 of a regular file reached without following a link; empty if there is none.
std::string sha256At(int folder, const std::string &name);

/// Content of a regular file reached without following a link; empty if there is none or it is
/// longer than `most` bytes.
std::optional<std::string> textAt(int folder, const std::string &name, std::size_t most);

/// Opens a folder below without following a link; -1 with errno.
int openFolderAt(int folder, const std::string &name);

/// Names of everything in an open folder but "." and "..".
std::vector<std::string> namesIn(int folder);

/// Renames without replacing anything; false with errno (EEXIST if something has the new name).
bool renameToFree(int fromFolder, const std::string &from, int toFolder, const std::string &to);

/// Removes a file, or a folder with what is in it, without following links. True if it is gone.
bool removeTree(int folder, const std::string &name);

} // namespace dyncal
