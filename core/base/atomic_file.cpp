// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/atomic_file.h"

#include "core/base/durable_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dyncal {
namespace {

constexpr mode_t kNewFileMode = 0666; // less the process's umask
constexpr int kMostNames = 100;

tl::unexpected<Error> cannotWrite(const std::string &path, int errorNumber)
{
    const bool isPlace = errorNumber == EACCES || errorNumber == ENOENT || errorNumber == ENOTDIR
        || errorNumber == EISDIR || errorNumber == EROFS || errorNumber == EPERM
        || errorNumber == ENAMETOOLONG;
    return fail(isPlace ? ErrorKind::Usage : ErrorKind::Internal,
        {DYNCAL_TEXT("core", "%1 cannot be written: %2."), {path, std::strerror(errorNumber)}});
}

/// A file that disappears again unless it is renamed to its final name.
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::string &target)
    {
        const std::string stem = target + ".part-" + std::to_string(::getpid()) + "-";
        for (int i = 0; i < kMostNames && m_descriptor < 0; ++i) {
            m_path = stem + std::to_string(i);
            m_descriptor
                = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
            if (m_descriptor < 0 && errno != EEXIST)
                break;
        }
        m_exists = m_descriptor >= 0;
    }

    ~TemporaryFile()
    {
        if (m_descriptor >= 0)
            ::close(m_descriptor);
        if (m_exists)
            ::unlink(m_path.c_str());
    }

    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    bool isOpen() const { return m_descriptor >= 0; }

    bool write(std::string_view bytes)
    {
        while (!bytes.empty()) {
            const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR)
                continue;
            if (written < 0)
                return false;
            bytes.remove_prefix(static_cast<std::size_t>(written));
        }
        return true;
    }

    bool moveTo(const std::string &target)
    {
        if (::close(std::exchange(m_descriptor, -1)) != 0 || !moveIntoPlace(m_path, target))
            return false;
        m_exists = false;
        return true;
    }

private:
    std::string m_path;
    int m_descriptor = -1;
    bool m_exists = false;
};

} // namespace

Result<void> writeFileAtomically(const std::string &path, std::string_view bytes)
{
    struct stat status = {};
    if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "%1 cannot be written: something that is no regular file has this name; choose "
                 "another."),
                {path}});
    TemporaryFile file(path);
    if (!file.isOpen() || !file.write(bytes) || !file.moveTo(path))
        return cannotWrite(path, errno);
    return {};
}

} // namespace dyncal
