// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/folder_plan.h"

#include "core/base/file_descriptor.h"
#include "core/base/json_text.h"
#include "core/base/writing/file_identity.h"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace dyncal {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestPlan = 32U << 20U;
constexpr mode_t kPrivateFile = 0600;

} // namespace

bool writePlan(int staging, const std::string &name, const FolderPlan &plan)
{
    const std::string text = jsonText(Json{{"tree", plan.tree}, {"folder", plan.folder},
        {"retired", writtenListText(plan.retired)}, {"placed", writtenListText(plan.placed)}});
    const std::string part = name + ".part";
    FileDescriptor file(::openat(
        staging, part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kPrivateFile));
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
    const auto isNumber = [&json](const char *key) {
        return json.is_object() && json.contains(key) && json[key].is_number_unsigned();
    };
    if (!isNumber("tree") || !isNumber("folder") || !isOwnedByUser(staging, name))
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
    return FolderPlan{json["tree"].get<ino_t>(), json["folder"].get<ino_t>(), *retired, *placed};
}

} // namespace dyncal
