// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_scribe.h"

#include "core/base/number_text.h"
#include "core/capture/formats/hdf5/hdf5_create.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace dyncal {
namespace {

bool isIdentifier(std::string_view key)
{
    static constexpr std::array<std::string_view, 7> kIdentifiers{"serial", "model", "manufacturer",
        "vendor", "certificate", "conditioner", "calibration_date"};
    return std::find(kIdentifiers.begin(), kIdentifiers.end(), key) != kIdentifiers.end();
}

/// HDF5 ends names and texts at a zero, so "a\0b" and "a\0c" would become the same channel.
std::string withoutZeros(std::string text)
{
    std::replace(text.begin(), text.end(), '\0', '|');
    return text;
}

bool writeAttribute(hid_t object, const std::string &name, hid_t stored, hid_t memory, hid_t space,
    const void *data)
{
    Hdf5Handle attribute(
        H5Acreate2(object, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT), &H5Aclose);
    return attribute.valid() && H5Awrite(attribute.id(), memory, data) >= 0 && attribute.close();
}

bool writeScalar(
    hid_t object, const std::string &name, hid_t stored, hid_t memory, const void *data)
{
    const Hdf5Handle space(H5Screate(H5S_SCALAR), &H5Sclose);
    return space.valid() && writeAttribute(object, name, stored, memory, space.id(), data);
}

bool writeList(hid_t object, const std::string &name, hid_t stored, hid_t memory, std::size_t size,
    const void *data)
{
    const hsize_t extent = size;
    const Hdf5Handle space(H5Screate_simple(1, &extent, nullptr), &H5Sclose);
    return space.valid() && writeAttribute(object, name, stored, memory, space.id(), data);
}

Hdf5Handle variableTextType()
{
    Hdf5Handle type(H5Tcopy(H5T_C_S1), &H5Tclose);
    const bool usable = type.valid() && H5Tset_size(type.id(), H5T_VARIABLE) >= 0
        && H5Tset_cset(type.id(), H5T_CSET_UTF8) >= 0;
    return usable ? std::move(type) : Hdf5Handle();
}

} // namespace

Hdf5Scribe::Hdf5Scribe(hid_t file, Hdf5Tree &tree)
    : Hdf5Scribe({H5Gopen2(file, "/", H5P_DEFAULT), &H5Gclose}, tree, 0)
{
    tree.objects.assign(1, {});
}

Hdf5Scribe::Hdf5Scribe(Hdf5Handle handle, Hdf5Tree &tree, Index position)
    : m_handle(std::move(handle))
    , m_tree(&tree)
    , m_position(position)
{
}

Hdf5Scribe Hdf5Scribe::member(Hdf5Handle handle, const std::string &name)
{
    const Index position = std::ssize(m_tree->objects);
    m_tree->objects.emplace_back();
    said().links.push_back({name, position});
    return {std::move(handle), *m_tree, position};
}

Hdf5Scribe Hdf5Scribe::group(const std::string &name)
{
    return member(createGroup(id(), name), name);
}

Hdf5Scribe Hdf5Scribe::dataset(const std::string &name, const RawSamples &samples)
{
    Hdf5Scribe made = member(createSampleDataset(id(), name, samples), name);
    Hdf5Object &said = made.said();
    said.isDataset = 1;
    said.dataset.type = samples.type();
    said.dataset.shape = {static_cast<std::uint64_t>(samples.size())};
    return made;
}

bool Hdf5Scribe::keep(bool written, const std::string &name, std::vector<double> numbers)
{
    said().attributes[name] = {Hdf5ValueKind::Numbers, {}, std::move(numbers)};
    return written;
}

bool Hdf5Scribe::text(const std::string &name, const std::string &text)
{
    const Hdf5Handle type = variableTextType();
    const std::string whole = withoutZeros(text);
    const char *data = whole.c_str();
    said().attributes[name] = {Hdf5ValueKind::Text, whole, {}};
    return type.valid() && writeScalar(id(), name, type.id(), type.id(), &data);
}

bool Hdf5Scribe::number(const std::string &name, double value)
{
    return keep(writeScalar(id(), name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value), name, {value});
}

bool Hdf5Scribe::integer(const std::string &name, int value)
{
    return keep(writeScalar(id(), name, H5T_STD_I32LE, H5T_NATIVE_INT, &value), name,
        {static_cast<double>(value)});
}

bool Hdf5Scribe::byte(const std::string &name, int value)
{
    return keep(writeScalar(id(), name, H5T_STD_I8LE, H5T_NATIVE_INT, &value), name,
        {static_cast<double>(value)});
}

bool Hdf5Scribe::numbers(const std::string &name, const std::vector<double> &values)
{
    return keep(
        writeList(id(), name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.size(), values.data()),
        name, values);
}

bool Hdf5Scribe::integers(const std::string &name, const std::vector<int> &values)
{
    return keep(writeList(id(), name, H5T_STD_I32LE, H5T_NATIVE_INT, values.size(), values.data()),
        name, std::vector<double>(values.begin(), values.end()));
}

bool Hdf5Scribe::attributes(const Attributes &attributes)
{
    return std::all_of(attributes.begin(), attributes.end(), [&](const auto &entry) {
        const auto &[given, value] = entry;
        const std::string key = withoutZeros(given);
        const std::optional<double> parsed = isIdentifier(key) ? std::nullopt : parseNumber(value);
        return parsed ? number(key, *parsed) : text(key, value);
    });
}

} // namespace dyncal
