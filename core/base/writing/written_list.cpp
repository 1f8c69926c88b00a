// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/written_list.h"

#include "core/base/content_hash.h"
#include "core/base/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace dyncal {
namespace {

using Json = nlohmann::json;

constexpr const char *kSchema = "dyncal-written/1";

bool isPlainName(std::string_view name)
{
    const bool hasControls = std::ranges::any_of(
        name, [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\'; });
    bool plain = !hasControls && !name.empty();
    for (std::size_t begin = 0; plain && begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string_view part = name.substr(begin, end - begin);
        plain = !part.empty() && part != "." && part != "..";
        begin = end + 1;
    }
    return plain;
}

std::optional<std::string> textOf(const Json &object, const char *key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? std::optional(found->get<std::string>())
                                                       : std::nullopt;
}

} // namespace

const WrittenFile *listed(const WrittenList &list, const std::string &file)
{
    const auto found = std::ranges::find(list, file, &WrittenFile::file);
    return found == list.end() ? nullptr : &*found;
}

std::string writtenListText(WrittenList list)
{
    std::ranges::sort(list, {}, &WrittenFile::file);
    Json files = Json::array();
    for (const WrittenFile &file : list)
        files.push_back({{"by", file.by}, {"file", file.file}, {"sha256", file.sha256}});
    return jsonText(Json{{"schema", kSchema}, {"files", std::move(files)}});
}

std::optional<WrittenList> parseWrittenList(std::string_view text)
{
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || textOf(json, "schema") != kSchema || !json.contains("files")
        || !json["files"].is_array())
        return std::nullopt;
    WrittenList list;
    for (const Json &entry : json["files"]) {
        const auto file = entry.is_object() ? textOf(entry, "file") : std::nullopt;
        const auto by = file ? textOf(entry, "by") : std::nullopt;
        const auto hash = by ? textOf(entry, "sha256") : std::nullopt;
        if (!hash || !isPlainName(*file) || !isSha256Hex(*hash))
            return std::nullopt;
        list.push_back({*file, *by, *hash});
    }
    return list;
}

} // namespace dyncal
