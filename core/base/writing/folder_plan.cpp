// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/json_text.h"
#include "core/base/writing/folder_staging.h"

#include <cerrno>
#include <cstdio>
#include <set>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace dyncal {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestPlan = 32U << 20U;
constexpr mode_t kPrivate = 0600;
constexpr mode_t kFolderMode = 0777; // less the process's umask

} // namespace

bool writePlan(int staging, const std::string &name, const FolderPlan &plan)
{
    const std::string text = jsonText(Json{{"tree", plan.tree},
        {"retired", writtenListText(plan.retired)}, {"placed", writtenListText(plan.placed)}});
    const std::string part = name + ".part";
    FileDescriptor file(::openat(
        staging, part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kPrivate));
    if (!file.valid())
        return false;
    const ssize_t written = ::write(file.get(), text.data(), text.size());
    if (written >= 0 && written < static_cast<ssize_t>(text.size()))
        errno = ENOSPC;
    return written == static_cast<ssize_t>(text.size()) && ::fsync(file.get()) == 0 && file.close()
        && ::renameat(staging, part.c_str(), staging, name.c_str()) == 0 && ::fsync(staging) == 0;
}

std::optional<FolderPlan> readPlan(int staging, const std::string &name)
{
    const auto text = textAt(staging, name, kLongestPlan);
    const Json json = text ? Json::parse(*text, nullptr, false) : Json();
    if (!json.is_object() || !json.contains("tree") || !json["tree"].is_number_unsigned())
        return std::nullopt;
    const auto listOf = [&json](const char *key) {
        return json.contains(key) && json[key].is_string()
            ? parseWrittenList(json[key].get<std::string>())
            : std::nullopt;
    };
    const auto retired = listOf("retired");
    const auto placed = listOf("placed");
    if (!retired || !placed)
        return std::nullopt;
    return FolderPlan{json["tree"].get<ino_t>(), *retired, *placed};
}

bool syncFolders(int folder, const WrittenList &files)
{
    std::set<std::string> folders;
    for (const WrittenFile &file : files)
        if (const std::size_t slash = file.file.rfind('/'); slash != std::string::npos)
            folders.insert(file.file.substr(0, slash));
    for (const std::string &name : folders) {
        const FileDescriptor below(openFolderAt(folder, name));
        if (!below.valid() || ::fsync(below.get()) != 0)
            return false;
    }
    return ::fsync(folder) == 0;
}

bool makeFoldersFor(int folder, const std::string &name)
{
    for (std::size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
        if (::mkdirat(folder, name.substr(0, slash).c_str(), kFolderMode) != 0 && errno != EEXIST)
            return false;
    }
    return true;
}

void removeEmptyFoldersOf(int folder, const std::string &name)
{
    for (std::size_t slash = name.rfind('/'); slash != std::string::npos && slash > 0;
         slash = name.rfind('/', slash - 1))
        ::unlinkat(folder, name.substr(0, slash).c_str(), AT_REMOVEDIR);
}

} // namespace dyncal
