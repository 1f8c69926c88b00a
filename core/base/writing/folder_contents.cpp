// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_contents.h"

#include "core/base/content_hash.h"
#include "core/base/writing/file_modes.h"
#include "core/base/writing/write_problem.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

using FileNumber = std::pair<dev_t, ino_t>;

constexpr int kOpened = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

std::string pathIn(const FolderPlace &place, const std::string &name)
{
    return (fs::path(place.shown) / name).string();
}

tl::unexpected<Error> isForeign(const FolderPlace &place, const std::string &name)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 is in the way: this program did not write it, or an earlier version did, and it is not replaced. Choose another folder, or move it away."),
            {pathIn(place, name)}});
}

tl::unexpected<Error> isChanged(const FolderPlace &place, const std::string &name)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 was changed since this program wrote it and is not replaced. Choose another folder, or move it away."),
            {pathIn(place, name)}});
}

tl::unexpected<Error> holdsRecording(const FolderPlace &place, const std::string &recording)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The folder %1 holds the recording %2; results are written into a folder that holds none of their recordings. Choose another folder."),
            {place.shown, recording}});
}

tl::unexpected<Error> isOtherMount(const FolderPlace &place, const std::string &name)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 lies on another file system than the folder that holds it, so the two cannot be "
             "written in one step; choose another folder, or unmount it."),
            {pathIn(place, name)}});
}

/// Files cannot be moved from one mount to another.
Result<void> checkMounts(
    const FolderPlace &place, int folder, const std::vector<std::string> &names)
{
    for (const std::string &name : names)
        if (const bool isFolder = name.ends_with('/') && identityOf(folder, name + '.');
            isFolder && mountOf(folder, name + '.') != mountOf(folder, "."))
            return isOtherMount(place, name);
    return {};
}

bool liesIn(const fs::path &path, const fs::path &folder)
{
    const auto [end, ignored]
        = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end();
}

/// The recording's own file, or a second name of it in the folder or one level below.
Result<void> checkRecordings(
    const FolderPlace &place, const FolderRequest &request, const std::set<FileNumber> &inside)
{
    for (const std::string &recording : request.recordings) {
        std::error_code error;
        const fs::path real = fs::canonical(recording, error);
        struct stat status = {};
        if (error || ::stat(recording.c_str(), &status) != 0)
            continue;
        if (liesIn(real, place.path) || inside.contains({status.st_dev, status.st_ino}))
            return holdsRecording(place, recording);
    }
    return {};
}

/// No recipe or profile that was read may be overwritten.
Result<void> checkSettings(int folder, const FolderRequest &request)
{
    for (const std::string &given : request.settings) {
        struct stat read = {};
        if (::stat(given.c_str(), &read) != 0)
            continue;
        const bool isWritten = std::ranges::any_of(request.names, [&](const std::string &name) {
            struct stat written = {};
            return ::fstatat(folder, name.c_str(), &written, 0) == 0
                && written.st_dev == read.st_dev && written.st_ino == read.st_ino;
        });
        if (isWritten)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "%1 was given to be read and would be replaced by what is written; give it another name or choose another folder."),
                    {given}});
    }
    return {};
}

/// Of all that is in the folder and one level below: a recording may be a second name of it.
std::set<FileNumber> filesIn(int folder)
{
    std::set<FileNumber> files;
    for (const std::string &name : namesIn(folder)) {
        const auto identity = identityOf(folder, name);
        if (!identity)
            continue;
        if (identity->type == FileType::Regular)
            files.insert({identity->device, identity->inode});
        const FileDescriptor below(
            identity->type == FileType::Folder ? openFolderAt(folder, name) : -1);
        for (const std::string &deeper :
            below.valid() ? namesIn(below.get()) : std::vector<std::string>())
            if (const auto file = identityOf(below.get(), deeper))
                files.insert({file->device, file->inode});
    }
    return files;
}

mode_t modeOf(int folder, const std::string &name)
{
    struct stat status = {};
    const bool isKnown = ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
    return isKnown ? status.st_mode & kPermissions : 0;
}

/// Sorts the listed files; those that are gone are no longer listed.
Result<void> readList(
    const FolderPlace &place, const FolderRequest &request, FolderContents &contents)
{
    contents.list = identityOf(contents.folder.get(), kWrittenList);
    if (!contents.list)
        return {};
    const auto text = textAt(contents.folder.get(), kWrittenList, kLongestList);
    const auto list = text ? parseWrittenList(*text) : std::nullopt;
    if (!list)
        return isForeign(place, kWrittenList);
    contents.listSha256 = sha256Hex(*text);
    contents.listMode = modeOf(contents.folder.get(), kWrittenList);
    for (const WrittenFile &file : *list) {
        if (file.by != request.writer) {
            contents.others.push_back(file);
            continue;
        }
        if (!request.mayWrite(file.file))
            return isForeign(place, kWrittenList);
        const auto identity = identityOf(contents.folder.get(), file.file);
        if (!identity)
            continue;
        if (sha256At(contents.folder.get(), file.file) != file.sha256)
            return isChanged(place, file.file);
        contents.own.push_back({file, *identity, modeOf(contents.folder.get(), file.file)});
    }
    return {};
}

Result<void> checkName(const FolderPlace &place, const FolderContents &contents, std::string name)
{
    const bool wantsFolder = name.ends_with('/');
    if (wantsFolder)
        name.pop_back();
    if (const std::size_t slash = name.rfind('/'); slash != std::string::npos) {
        const Result<void> parent = checkName(place, contents, name.substr(0, slash + 1));
        if (!parent)
            return parent;
    }
    const auto identity = identityOf(contents.folder.get(), name);
    if (!identity || (wantsFolder && identity->type == FileType::Folder))
        return {};
    const bool isList = name == kWrittenList && contents.list; // read, so it is ours
    const bool isOwn = isList || std::ranges::any_of(contents.own, [&](const OwnFile &own) {
        return own.listed.file == name;
    });
    return isOwn && !wantsFolder ? Result<void>() : isForeign(place, name);
}

} // namespace

Result<FolderContents> inspectFolder(const FolderPlace &place, int claimFolder,
    const FolderRequest &request, const std::vector<std::string> &names)
{
    FolderContents contents;
    contents.folder = FileDescriptor(::openat(claimFolder, place.claimTarget.c_str(), kOpened));
    if (!contents.folder.valid()) {
        if (errno == ENOENT && place.claimTarget != ".")
            return contents;
        return cannotWrite(place.shown);
    }
    const Result<void> recordings = checkRecordings(place, request, filesIn(contents.folder.get()));
    if (!recordings)
        return tl::unexpected<Error>(recordings.error());
    if (const Result<void> mounts = checkMounts(place, contents.folder.get(), names); !mounts)
        return tl::unexpected<Error>(mounts.error());
    if (const Result<void> settings = checkSettings(contents.folder.get(), request); !settings)
        return tl::unexpected<Error>(settings.error());
    if (const Result<void> listed = readList(place, request, contents); !listed)
        return tl::unexpected<Error>(listed.error());
    for (const std::string &name : names)
        if (const Result<void> free = checkName(place, contents, name); !free)
            return tl::unexpected<Error>(free.error());
    return contents;
}

} // namespace dyncal
