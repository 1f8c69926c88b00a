// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QByteArray>
#include <QString>

#include <functional>
#include <memory>

namespace dyncal {

/// A lock that lives as long as this object, and no longer than its program: the system releases it
/// when the program is killed. QLockFile goes by process numbers and host names instead, which
/// repeat in containers (a sandboxed program has the same number at every start) and change.
class FileLock
{
public:
    /// Whether the lock's file, opened and locked, may be taken over from whoever left it.
    using Judge = std::function<bool(int file)>;

    /// Null where another program, or another object of this one, has it, `mayTake` says no, or it
    /// cannot be made.
    static std::unique_ptr<FileLock> take(const QString &path, const Judge &mayTake = {});
    ~FileLock(); ///< removes the file
    FileLock(const FileLock &) = delete;
    FileLock &operator=(const FileLock &) = delete;

    /// Puts these bytes into the file, readable for everybody, in the place of what is there.
    bool write(const QByteArray &bytes) const;
    /// Sets the file's time to now, by the clock of the machine that has the file.
    void touch() const;

private:
    FileLock(const std::string &path, int descriptor);

    std::string m_path;
    int m_descriptor;
};

} // namespace dyncal
