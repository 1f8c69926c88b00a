// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/pending_file.h"

#include "core/base/content_hash.h"
#include "core/base/writing/file_identity.h"
#include "core/base/writing/file_modes.h"
#include "core/base/writing/write_problem.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kNewFileMode = 0666; // less the process's umask

tl::unexpected<Error> isNoFile(const std::string &path)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 cannot be written: something that is no regular file has this name; choose another."),
            {path}});
}

tl::unexpected<Error> wasChanged(const std::string &path)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 was changed by another program since it was read here, and is not replaced; choose another name, or look at what it holds now."),
            {path}},
        kChangedMeanwhile);
}

std::string linkText(int folder, const std::string &name)
{
    std::array<char, 256> text; // the beginning is enough
    const ssize_t size = ::readlinkat(folder, name.c_str(), text.data(), text.size());
    return std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
}

/// Of what is read under this name, through a link too: that is the file that was looked at.
std::string hashAt(int folder, const std::string &name, const struct stat &status)
{
    return S_ISLNK(status.st_mode)
        ? sha256OfFile("/proc/self/fd/" + std::to_string(folder) + '/' + name)
        : sha256At(folder, name);
}

} // namespace

PendingFile::PendingFile(std::string path, std::string name, Existing existing, WriteClaim claim)
    : m_path(std::move(path))
    , m_name(std::move(name))
    , m_existing(std::move(existing))
    , m_claim(std::move(claim))
{
}

PendingFile::~PendingFile()
{
    if (m_exists && m_claim && ::unlinkat(m_claim->folder(), m_claim->temporary().c_str(), 0) != 0)
        m_claim->leaveBehind();
}

Result<PendingFile> PendingFile::create(const std::string &path, const Existing &existing)
{
    const fs::path whole(path);
    const std::string name = whole.filename().string();
    if (name.empty() || name == "." || name == "..")
        return cannotWrite(path, path.empty() ? ENOENT : EISDIR);
    const std::string folder = whole.parent_path().empty() ? "." : whole.parent_path().string();
    Result<WriteClaim> claim = WriteClaim::take(folder, name, ClaimKind::File, path);
    if (!claim)
        return tl::unexpected<Error>(claim.error());
    PendingFile file(path, name, existing, std::move(*claim));
    if (const Result<void> allowed = file.checkTarget(); !allowed)
        return tl::unexpected<Error>(allowed.error());
    file.m_file = FileDescriptor(::openat(file.m_claim->folder(), file.m_claim->temporary().c_str(),
        O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, file.firstMode()));
    if (!file.m_file.valid())
        return cannotWrite(path);
    file.m_exists = true;
    return file;
}

std::string PendingFile::openPath() const
{
    return "/proc/self/fd/" + std::to_string(m_file.get());
}

Result<void> PendingFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_file.get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return cannotWrite(m_path);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return {};
}

Result<void> PendingFile::checkTarget() const
{
    struct stat status = {};
    const int folder = m_claim->folder();
    if (::fstatat(folder, m_name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
        if (errno != ENOENT)
            return cannotWrite(m_path);
        const bool isMissed
            = m_existing.rule == Existing::Rule::ReplacedIfUnchanged && m_existing.sha256;
        return isMissed ? Result<void>(wasChanged(m_path)) : Result<void>();
    }
    if (m_existing.rule == Existing::Rule::Refused)
        return existsAlready(m_path);
    struct stat target = {};
    // Links in /proc stand for whatever a process has open.
    if (S_ISLNK(status.st_mode) && linkText(folder, m_name).starts_with("/proc/"))
        return isNoFile(m_path);
    const bool leadsElsewhere = S_ISLNK(status.st_mode)
        && ::fstatat(folder, m_name.c_str(), &target, 0) == 0 && !S_ISREG(target.st_mode);
    if ((!S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) || leadsElsewhere)
        return isNoFile(m_path);
    if (m_existing.rule == Existing::Rule::ReplacedIfUnchanged
        && (!m_existing.sha256 || hashAt(folder, m_name, status) != *m_existing.sha256))
        return wasChanged(m_path);
    return {};
}

/// Whoever may not read the finished file may not read it before either.
mode_t PendingFile::firstMode() const
{
    struct stat status = {};
    const bool replaces
        = ::fstatat(m_claim->folder(), m_name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0
        && S_ISREG(status.st_mode);
    return replaces ? kNewFileMode & (status.st_mode | S_IRUSR | S_IWUSR) : kNewFileMode;
}

/// A file that others may not read keeps that.
Result<void> PendingFile::keepMode() const
{
    const std::optional<FileIdentity> old = identityOf(m_claim->folder(), m_name);
    struct stat status = {};
    if (!old || old->type != FileType::Regular
        || ::fstatat(m_claim->folder(), m_name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return {};
    return ::fchmod(m_file.get(), status.st_mode & kPermissions) == 0 ? Result<void>()
                                                                      : cannotWrite(m_path);
}

bool PendingFile::takeName() const
{
    const int folder = m_claim->folder();
    const bool mayReplace = m_existing.rule == Existing::Rule::Replaced
        || (m_existing.rule == Existing::Rule::ReplacedIfUnchanged && m_existing.sha256);
    return mayReplace
        ? ::renameat(folder, m_claim->temporary().c_str(), folder, m_name.c_str()) == 0
        : renameToFree(folder, m_claim->temporary(), folder, m_name);
}

Result<void> PendingFile::commit()
{
    if (const Result<void> allowed = checkTarget(); !allowed)
        return allowed;
    if (const Result<void> kept = keepMode(); !kept)
        return kept;
    if (::fsync(m_file.get()) != 0 || !m_file.close())
        return cannotWrite(m_path);
    if (!takeName()) {
        if (errno != EEXIST)
            return cannotWrite(m_path);
        return m_existing.rule == Existing::Rule::Refused ? existsAlready(m_path)
                                                          : Result<void>(wasChanged(m_path));
    }
    m_exists = false;
    return ::fsync(m_claim->folder()) == 0 ? Result<void>() : cannotWrite(m_path);
}

} // namespace dyncal
