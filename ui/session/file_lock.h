// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

#include <memory>

namespace dyncal {

/// A lock that lives as long as this object, and no longer than its program: the system releases it
/// when the program is killed. QLockFile goes by process numbers and host names instead, which
/// repeat in containers (a sandboxed program has the same number at every start) and change.
class FileLock
{
public:
    /// Null where another program, or another object of this one, has it, or it cannot be made.
    static std::unique_ptr<FileLock> take(const QString &path);
    ~FileLock(); ///< removes the file
    FileLock(const FileLock &) = delete;
    FileLock &operator=(const FileLock &) = delete;

private:
    FileLock(const std::string &path, int descriptor);

    std::string m_path;
    int m_descriptor;
};

} // namespace dyncal
