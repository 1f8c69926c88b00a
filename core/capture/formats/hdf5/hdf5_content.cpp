// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_content.h"

#include "core/base/content_hash.h"

#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <span>
#include <utility>

namespace dyncal {
namespace {

/// Places that are named one by one.
constexpr std::size_t kMostNamed = 5;
constexpr std::string_view kShots = "/shots/";

using Hashes = std::map<std::string, std::string>; ///< by path

/// "5:hello,": with its length no content can be mistaken for structure.
void addField(std::string &bytes, std::string_view field)
{
    bytes += std::to_string(field.size());
    bytes += ':';
    bytes += field;
    bytes += ',';
}

std::string hexOf(double value)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto bits = std::bit_cast<std::uint64_t>(value);
    std::string hex;
    for (int shift = 60; shift >= 0; shift -= 4)
        hex += kDigits[(bits >> static_cast<unsigned int>(shift)) & 15U];
    return hex;
}

void addValue(std::string &bytes, const Hdf5Value &value)
{
    std::string numbers;
    for (const double number : value.numbers)
        numbers += hexOf(number);
    switch (value.kind) {
    case Hdf5ValueKind::Text:
        addField(bytes, "text");
        addField(bytes, value.text);
        return;
    case Hdf5ValueKind::Numbers:
        addField(bytes, "numbers");
        addField(bytes, numbers);
        return;
    case Hdf5ValueKind::Unreadable:
        addField(bytes, "other");
        addField(bytes, "");
    }
}

const char *nameOf(SampleType type)
{
    static constexpr std::array kNames{
        "int16", "int32", "float32", "float64", "int8", "uint8", "uint16"}; // as SampleType
    return kNames[static_cast<std::size_t>(type)];
}

std::string hashOf(const Hdf5Tree &tree, const Hdf5Object &object)
{
    const bool isRoot = &object == &tree.objects.front();
    std::string bytes;
    addField(bytes, object.isDataset != 0 ? "dataset" : "group");
    for (const auto &[name, value] : object.attributes) {
        if (isRoot && (name == kContentHash || name == kContentList))
            continue;
        addField(bytes, "attribute");
        addField(bytes, name);
        addValue(bytes, value);
    }
    if (object.tooManyAttributes != 0)
        addField(bytes, "too many attributes");
    for (const Hdf5Link &link : object.links) {
        addField(bytes, link.target >= 0 ? "member" : "other member");
        addField(bytes, link.name);
    }
    if (object.isDataset != 0) {
        const bool isExact = object.dataset.fidelity == Hdf5Fidelity::Exact;
        addField(bytes, isExact ? nameOf(object.dataset.type) : object.dataset.typeText.c_str());
        for (const std::uint64_t extent : object.dataset.shape)
            addField(bytes, std::to_string(extent));
    }
    return sha256Hex(bytes);
}

/// Each object once, by the shortest path that leads to it.
std::map<std::string, const Hdf5Object *> paths(const Hdf5Tree &tree)
{
    std::map<std::string, const Hdf5Object *> found;
    std::vector<bool> seen(tree.objects.size(), false);
    std::deque<std::pair<std::string, std::size_t>> next{{"", 0}};
    seen[0] = true;
    while (!next.empty()) {
        const auto [path, position] = std::move(next.front());
        next.pop_front();
        const Hdf5Object &object = tree.objects[position];
        found.emplace(path.empty() ? "/" : path, &object);
        for (const Hdf5Link &link : object.links) {
            const auto target = static_cast<std::size_t>(link.target);
            if (link.target < 0 || seen[target])
                continue;
            seen[target] = true;
            next.emplace_back(path + "/" + link.name, target);
        }
    }
    return found;
}

/// The path without line breaks.
std::string escaped(const std::string &path)
{
    std::string text;
    for (const char letter : path) {
        if (letter == '\n')
            text += "\\n";
        else if (letter == '\\')
            text += "\\\\";
        else
            text += letter;
    }
    return text;
}

Hashes hashesIn(std::string_view list)
{
    Hashes hashes;
    while (!list.empty()) {
        const std::string_view line = list.substr(0, list.find('\n'));
        list.remove_prefix(std::min(line.size() + 1, list.size()));
        if (line.size() > kSha256Digits + 2)
            hashes.emplace(line.substr(kSha256Digits + 2), line.substr(0, kSha256Digits));
    }
    return hashes;
}

/// Paths of what differs between the two, in order.
std::vector<std::string> differences(const Hashes &stated, const Hashes &found)
{
    std::vector<std::string> paths;
    for (const auto &[path, hash] : stated) {
        const auto now = found.find(path);
        if (now == found.end() || now->second != hash)
            paths.push_back(path);
    }
    for (const auto &[path, hash] : found) {
        if (!stated.contains(path))
            paths.push_back(path);
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// Number from 1 of the shot that the path lies in, in the order of the file; 0 if in none.
Index shotOf(const Hdf5Tree &tree, const std::string &path)
{
    const Hdf5Object *shots = memberOf(tree, tree.objects.front(), "shots");
    if (shots == nullptr || !path.starts_with(kShots))
        return 0;
    const std::string name
        = path.substr(kShots.size(), path.find('/', kShots.size()) - kShots.size());
    const auto link = std::ranges::find(shots->links, name, &Hdf5Link::name);
    return link != shots->links.end() ? link - shots->links.begin() + 1 : 0;
}

std::string channelOf(const std::string &path)
{
    constexpr std::string_view kChannels = "/channels/";
    const std::size_t begin = path.find(kChannels);
    return path.starts_with(kShots) && begin != std::string::npos
        ? path.substr(begin + kChannels.size())
        : std::string();
}

Message sentence(
    const std::string &file, const std::string &path, Index shot, const std::string &channel)
{
    if (!channel.empty())
        return {
            DYNCAL_TEXT("core",
                "%1 changed since it was written: what it says of channel '%2' of shot %3 is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy."),
            {file, channel, std::to_string(shot)}};
    if (shot > 0)
        return {
            DYNCAL_TEXT("core",
                "%1 changed since it was written: what it says of shot %2 (%3) is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy."),
            {file, std::to_string(shot), path}};
    return {
        DYNCAL_TEXT("core",
            "%1 changed since it was written: what it says in %2 is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy."),
        {file, path}};
}

Finding changed(Message message, Index shot = 0, const std::string &channel = {})
{
    return {.id = "CAP-015",
        .severity = Severity::Block,
        .shot = shot,
        .channel = channel,
        .message = std::move(message)};
}

} // namespace

std::string contentList(const Hdf5Tree &tree)
{
    std::string list;
    for (const auto &[path, object] : paths(tree))
        list += hashOf(tree, *object) + "  " + escaped(path) + "\n";
    return list;
}

bool statesContent(const Hdf5Attributes &root)
{
    return root.contains(kContentHash) || root.contains(kContentList);
}

Findings checkContent(const Hdf5Tree &tree, const std::string &path)
{
    const Hdf5Object &root = tree.objects.front();
    if (!statesContent(root.attributes))
        return {};
    const std::string found = contentList(tree);
    const std::string stated = textAttribute(root, kContentList).value_or("");
    const bool isSound = textAttribute(root, kContentHash) == sha256Hex(stated);
    if (isSound && stated == found)
        return {};
    const std::vector<std::string> places = differences(hashesIn(stated), hashesIn(found));
    if (!isSound || places.empty())
        return {changed(
            {DYNCAL_TEXT("core",
                 "%1 changed since it was written: the hashes it states of itself contradict each other, so that nothing in it can be certified; take an unchanged copy."),
                {path}})};
    Findings findings;
    for (std::size_t i = 0; i < std::min(places.size(), kMostNamed); ++i) {
        const Index shot = shotOf(tree, places[i]);
        const std::string channel = channelOf(places[i]);
        findings.push_back(changed(sentence(path, places[i], shot, channel), shot, channel));
    }
    if (places.size() > kMostNamed)
        findings.push_back(changed(
            {DYNCAL_TEXT("core",
                 "%1 changed since it was written in %2 further places; take an unchanged copy."),
                {path, std::to_string(places.size() - kMostNamed)}}));
    return findings;
}

} // namespace dyncal
