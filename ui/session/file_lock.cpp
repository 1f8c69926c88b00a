// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/file_lock.h"

#include <QFile>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dyncal {

namespace {

constexpr mode_t kMode = 0600;
constexpr mode_t kReadable = 0666; // another account of the group must be able to take it over
/// Another program may release the lock just now and remove the file; not many times in a row.
constexpr int kTries = 10;

bool isStillThere(int descriptor, const char *path)
{
    struct stat opened = {};
    struct stat named = {};
    return ::fstat(descriptor, &opened) == 0 && ::stat(path, &named) == 0
        && opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

} // namespace

FileLock::FileLock(const std::string &path, int descriptor)
    : m_path(path)
    , m_descriptor(descriptor)
{
}

FileLock::~FileLock()
{
    if (isStillThere(m_descriptor, m_path.c_str())) // else it is another's by now
        ::unlink(m_path.c_str());
    ::flock(m_descriptor, LOCK_UN); // also for a child that still holds the descriptor
    ::close(m_descriptor);
}

std::unique_ptr<FileLock> FileLock::take(const QString &path, const Judge &mayTake)
{
    const std::string name = QFile::encodeName(path).toStdString();
    for (int i = 0; i < kTries; ++i) {
        const int descriptor
            = ::open(name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, kMode);
        if (descriptor < 0)
            return nullptr;
        const bool isHeld = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
        const bool isOurs = !isHeld && isStillThere(descriptor, name.c_str());
        if (isOurs && (!mayTake || mayTake(descriptor)))
            return std::unique_ptr<FileLock>(new FileLock(name, descriptor));
        ::close(descriptor);
        if (isHeld || isOurs)
            return nullptr;
    }
    return nullptr;
}

bool FileLock::write(const QByteArray &bytes) const
{
    (void)::fchmod(m_descriptor, kReadable); // some file systems have no modes
    return ::ftruncate(m_descriptor, 0) == 0
        && ::pwrite(m_descriptor, bytes.constData(), static_cast<std::size_t>(bytes.size()), 0)
        == bytes.size();
}

void FileLock::touch() const
{
    (void)::futimens(m_descriptor, nullptr);
}

} // namespace dyncal
