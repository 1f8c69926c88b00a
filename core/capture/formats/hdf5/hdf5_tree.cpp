// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_tree.h"

#include "core/base/number_text.h"
#include "core/capture/formats/bytes/byte_stream.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

template <typename Stream>
static void transfer(Stream &stream, Hdf5Value &value)
{
    stream(value.kind, value.text, value.numbers);
}

template <typename Stream>
static void transfer(Stream &stream, Hdf5Dataset &dataset)
{
    stream(dataset.typeText, dataset.shape, dataset.obstacle, dataset.missingFilter,
        dataset.elsewhere, dataset.unpackedBytes, dataset.allowedBytes, dataset.chunkBytes,
        dataset.storage, dataset.type, dataset.fidelity, dataset.bigEndian, dataset.blockShape,
        dataset.blockOffsets);
}

template <typename Stream>
static void transfer(Stream &stream, Hdf5Link &link)
{
    stream(link.name, link.target);
}

template <typename Stream>
static void transfer(Stream &stream, Hdf5Object &object)
{
    stream(object.isDataset, object.tooManyAttributes, object.address, object.attributes,
        object.links, object.dataset);
}

namespace {

/// Whether an enumerator lies within its enumeration, which counts from 0 to `last`.
template <typename Enum>
bool isKnown(Enum value, Enum last)
{
    return static_cast<int>(value) >= 0 && static_cast<int>(value) <= static_cast<int>(last);
}

bool isSound(const Hdf5Object &object, Index objects)
{
    const Hdf5Dataset &dataset = object.dataset;
    return isKnown(dataset.obstacle, Hdf5Obstacle::OverBudget)
        && isKnown(dataset.storage, Hdf5Storage::Packed)
        && isKnown(dataset.type, SampleType::UInt16)
        && isKnown(dataset.fidelity, Hdf5Fidelity::MayRound)
        && (dataset.obstacle == Hdf5Obstacle::None) == (dataset.storage != Hdf5Storage::Nowhere)
        && std::all_of(object.attributes.begin(), object.attributes.end(),
            [](const auto &attribute) {
                return isKnown(attribute.second.kind, Hdf5ValueKind::Unreadable);
            })
        && std::all_of(object.links.begin(), object.links.end(), [&](const Hdf5Link &link) {
               return link.target >= Hdf5Link::kNotRead && link.target < objects;
           });
}

const Hdf5Value *valueOf(const Hdf5Object &object, const std::string &name)
{
    const auto found = object.attributes.find(name);
    return found != object.attributes.end() ? &found->second : nullptr;
}

std::optional<std::string> textOf(const Hdf5Value &value)
{
    if (value.kind == Hdf5ValueKind::Text)
        return value.text;
    const bool isNumber = value.kind == Hdf5ValueKind::Numbers && value.numbers.size() == 1;
    return isNumber ? std::optional(exactNumber(value.numbers.front())) : std::nullopt;
}

} // namespace

std::uint64_t Hdf5Dataset::elements() const
{
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t product = 1;
    for (const std::uint64_t extent : shape)
        product = extent != 0 && product > kMost / extent ? kMost : product * extent;
    return product;
}

std::vector<std::byte> packed(const Hdf5Tree &tree)
{
    BytePacker packer;
    packer(tree.objects, tree.tooManyBytes);
    return packer.bytes();
}

std::optional<Hdf5Tree> unpackedTree(std::span<const std::byte> bytes)
{
    ByteUnpacker unpacker(bytes);
    Hdf5Tree tree;
    unpacker(tree.objects, tree.tooManyBytes);
    const Index objects = std::ssize(tree.objects);
    const bool sound = unpacker.ok() && unpacker.atEnd() && objects > 0
        && std::all_of(tree.objects.begin(), tree.objects.end(),
            [&](const Hdf5Object &object) { return isSound(object, objects); });
    return sound ? std::optional(std::move(tree)) : std::nullopt;
}

const Hdf5Object *memberOf(const Hdf5Tree &tree, const Hdf5Object &group, const std::string &name)
{
    const auto link = std::find_if(group.links.begin(), group.links.end(),
        [&](const Hdf5Link &candidate) { return candidate.name == name; });
    if (link == group.links.end() || link->target < 0)
        return nullptr;
    return &tree.objects[static_cast<std::size_t>(link->target)];
}

const Hdf5Object *objectAt(const Hdf5Tree &tree, std::string_view path)
{
    const Hdf5Object *object = &tree.objects.front();
    while (object != nullptr && !path.empty()) {
        path.remove_prefix(1); // the slash before each name
        const std::string_view name = path.substr(0, path.find('/'));
        object = memberOf(tree, *object, std::string(name));
        path.remove_prefix(name.size());
    }
    return object;
}

std::optional<std::string> textAttribute(const Hdf5Object &object, const std::string &name)
{
    const Hdf5Value *value = valueOf(object, name);
    return value != nullptr ? textOf(*value) : std::nullopt;
}

std::optional<double> numberAttribute(const Hdf5Object &object, const std::string &name)
{
    const Hdf5Value *value = valueOf(object, name);
    if (value == nullptr || value->kind == Hdf5ValueKind::Unreadable)
        return std::nullopt;
    if (value->kind == Hdf5ValueKind::Text)
        return parseNumber(value->text);
    return value->numbers.size() == 1 ? std::optional(value->numbers.front()) : std::nullopt;
}

bool isNoNumber(const Hdf5Object &object, const std::string &name)
{
    return valueOf(object, name) != nullptr && !numberAttribute(object, name);
}

std::vector<double> numbersAttribute(const Hdf5Object &object, const std::string &name)
{
    const Hdf5Value *value = valueOf(object, name);
    return value != nullptr ? value->numbers : std::vector<double>();
}

std::map<std::string, std::string> attributeTexts(const Hdf5Object &object)
{
    std::map<std::string, std::string> texts;
    for (const auto &[name, value] : object.attributes) {
        const std::optional<std::string> text = textOf(value);
        if (text && *text != "nan")
            texts[name] = *text;
    }
    return texts;
}

} // namespace dyncal
