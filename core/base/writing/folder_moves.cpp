// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_moves.h"

#include "core/base/file_descriptor.h"
#include "core/base/writing/file_identity.h"
#include "core/base/writing/folder_paths.h"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>

namespace dyncal {
namespace {

/// Moves one file, making the folders on its way, which go into `made`.
bool moveFile(int from, const std::string &source, int to, const std::string &target,
    std::vector<std::string> *made = nullptr)
{
    if (!makeFoldersFor(to, target, made))
        return false;
    const FileDescriptor sourceFolder = parentOf(from, source);
    const FileDescriptor targetFolder = parentOf(to, target);
    return sourceFolder.valid() && targetFolder.valid()
        && renameToFree(sourceFolder.get(), source.substr(source.rfind('/') + 1),
            targetFolder.get(), target.substr(target.rfind('/') + 1));
}

class Moves
{
public:
    Moves(int staging, int folder, const FolderPlan &plan)
        : m_staging(staging)
        , m_folder(folder)
        , m_plan(plan)
    {
    }

    bool forward()
    {
        return std::ranges::all_of(m_plan.retired, [this](const auto &file) {
            return retire(file);
        }) && std::ranges::all_of(m_plan.placed, [this](const auto &file) { return place(file); });
    }

    /// As it was; errno is kept.
    void back()
    {
        const int problem = errno;
        for (const WrittenFile &file : m_plan.placed) {
            if (!isThere(m_staging, m_tree + file.file)
                && sha256At(m_folder, file.file) == file.sha256)
                moveFile(m_folder, file.file, m_staging, m_tree + file.file);
        }
        for (; !m_made.empty(); m_made.pop_back())
            removeEmptyFolder(m_folder, m_made.back());
        for (const WrittenFile &file : m_plan.retired)
            if (isThere(m_staging, m_old + file.file))
                moveFile(m_staging, m_old + file.file, m_folder, file.file);
        errno = problem;
    }

private:
    static bool isThere(int folder, const std::string &name)
    {
        return identityOf(folder, name).has_value();
    }

    /// Only what is still the file that was looked at.
    bool retire(const WrittenFile &file) const
    {
        const bool isPlacedAlready
            = listed(m_plan.placed, file.file) && !isThere(m_staging, m_tree + file.file);
        if (isThere(m_staging, m_old + file.file) || isPlacedAlready
            || !isThere(m_folder, file.file))
            return true;
        if (sha256At(m_folder, file.file) != file.sha256) {
            errno = EEXIST;
            return false;
        }
        return moveFile(m_folder, file.file, m_staging, m_old + file.file);
    }

    bool place(const WrittenFile &file)
    {
        return !isThere(m_staging, m_tree + file.file)
            || moveFile(m_staging, m_tree + file.file, m_folder, file.file, &m_made);
    }

    int m_staging;
    int m_folder;
    const FolderPlan &m_plan;
    const std::string m_tree = std::string(kStagedTree) + '/';
    const std::string m_old = std::string(kRetired) + '/';
    std::vector<std::string> m_made; ///< folders that were not there before
};

bool linkFolder(int from, int to, const std::string &below, const WrittenList &retired);

/// Gives one entry a second name; false if it cannot have one.
bool linkEntry(
    int from, int to, const std::string &below, const std::string &name, const WrittenList &retired)
{
    const std::string whole = below + name;
    if (listed(retired, whole))
        return true;
    const auto identity = identityOf(from, name);
    if (!identity)
        return true; // gone meanwhile
    if (identity->type != FileType::Folder) {
        const auto there = identityOf(to, name);
        return (there && there->isSameFile(*identity))
            || ::linkat(from, name.c_str(), to, name.c_str(), 0) == 0;
    }
    // A folder that holds our files may be made anew; other folders are not copied.
    const bool holdsOurs = std::ranges::any_of(
        retired, [&](const WrittenFile &file) { return file.file.starts_with(whole + '/'); });
    const FileDescriptor inside(holdsOurs ? openFolderAt(from, name) : -1);
    if (!inside.valid() || (::mkdirat(to, name.c_str(), 0777) != 0 && errno != EEXIST))
        return false;
    const FileDescriptor copy(openFolderAt(to, name));
    struct stat status = {};
    const bool isLinked = copy.valid() && ::fstat(inside.get(), &status) == 0
        && ::fchmod(copy.get(), status.st_mode & 07777) == 0
        && linkFolder(inside.get(), copy.get(), whole + '/', retired);
    ::unlinkat(to, name.c_str(), AT_REMOVEDIR); // if nothing is in it, as the moves do
    return isLinked;
}

bool linkFolder(int from, int to, const std::string &below, const WrittenList &retired)
{
    return std::ranges::all_of(namesIn(from),
        [&](const std::string &name) { return linkEntry(from, to, below, name, retired); });
}

} // namespace

bool carryOutMoves(int staging, int folder, const FolderPlan &plan)
{
    Moves moves(staging, folder, plan);
    if (!moves.forward()) {
        moves.back();
        return false;
    }
    for (const WrittenFile &file : plan.retired)
        removeEmptyFoldersOf(folder, file.file);
    return syncFolders(folder, plan.placed);
}

void takeBackMoves(int staging, int folder, const FolderPlan &plan)
{
    Moves(staging, folder, plan).back();
}

bool linkKept(int folder, int tree, const WrittenList &retired)
{
    return linkFolder(folder, tree, {}, retired);
}

} // namespace dyncal
