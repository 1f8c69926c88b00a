// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_attributes.h"

#include <algorithm>

namespace dyncal {
namespace {

/// This layout has no longer texts and lists; a broken size must not be allocated.
constexpr hsize_t kMaxTextBytes = 1 << 20;
constexpr hssize_t kMaxNumbers = 64;

/// An opened attribute with its type and number of elements; elements 0 = not usable.
struct OpenAttribute
{
    Hdf5Handle attribute;
    Hdf5Handle type;
    hssize_t elements = 0;

    H5T_class_t typeClass() const { return H5Tget_class(type.id()); }
    bool isNumeric() const { return typeClass() == H5T_INTEGER || typeClass() == H5T_FLOAT; }
};

OpenAttribute openAttribute(hid_t object, const std::string &name)
{
    OpenAttribute opened;
    if (H5Aexists(object, name.c_str()) <= 0)
        return opened;
    opened.attribute = Hdf5Handle(H5Aopen(object, name.c_str(), H5P_DEFAULT), &H5Aclose);
    if (!opened.attribute.valid())
        return opened;
    opened.type = Hdf5Handle(H5Aget_type(opened.attribute.id()), &H5Tclose);
    const Hdf5Handle space(H5Aget_space(opened.attribute.id()), &H5Sclose);
    const bool small = H5Aget_storage_size(opened.attribute.id()) <= kMaxTextBytes;
    if (opened.type.valid() && space.valid() && small)
        opened.elements = std::max<hssize_t>(H5Sget_simple_extent_npoints(space.id()), 0);
    return opened;
}

std::optional<std::string> variableText(const OpenAttribute &opened)
{
    // The character set must be that of the stored type, the library converts none.
    const Hdf5Handle memory(H5Tcopy(opened.type.id()), &H5Tclose);
    char *text = nullptr;
    if (!memory.valid() || H5Aread(opened.attribute.id(), memory.id(), &text) < 0)
        return std::nullopt;
    std::string copy = text != nullptr ? text : "";
    H5free_memory(text);
    return copy;
}

std::optional<std::string> fixedText(const OpenAttribute &opened)
{
    const std::size_t size = H5Tget_size(opened.type.id());
    if (size == 0 || size > kMaxTextBytes)
        return std::nullopt;
    std::string text(size, '\0');
    if (H5Aread(opened.attribute.id(), opened.type.id(), text.data()) < 0)
        return std::nullopt;
    text.resize(std::min(text.find('\0'), text.size()));
    text.erase(text.find_last_not_of(' ') + 1); // space padded, as Fortran and LabVIEW write it
    return text;
}

std::optional<std::string> textOf(const OpenAttribute &opened)
{
    if (opened.elements != 1 || opened.typeClass() != H5T_STRING)
        return std::nullopt;
    return H5Tis_variable_str(opened.type.id()) > 0 ? variableText(opened) : fixedText(opened);
}

std::vector<double> numbersOf(const OpenAttribute &opened)
{
    if (opened.elements < 1 || opened.elements > kMaxNumbers || !opened.isNumeric())
        return {};
    std::vector<double> values(static_cast<std::size_t>(opened.elements));
    if (H5Aread(opened.attribute.id(), H5T_NATIVE_DOUBLE, values.data()) < 0)
        return {};
    return values;
}

herr_t collectName(hid_t, const char *name, const H5A_info_t *, void *data)
{
    static_cast<std::vector<std::string> *>(data)->emplace_back(name);
    return 0;
}

Hdf5Value valueOf(const OpenAttribute &opened)
{
    if (std::optional<std::string> text = textOf(opened))
        return {Hdf5ValueKind::Text, std::move(*text), {}};
    std::vector<double> numbers = numbersOf(opened);
    if (!numbers.empty())
        return {Hdf5ValueKind::Numbers, {}, std::move(numbers)};
    return {};
}

} // namespace

Hdf5Attributes readAttributes(hid_t object, DescribedBytes &bytes)
{
    constexpr std::size_t kEntry = sizeof(Hdf5Attributes::value_type) + 4 * sizeof(void *);
    std::vector<std::string> names;
    Hdf5Attributes attributes;
    if (H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, &collectName, &names) < 0)
        return attributes;
    for (const std::string &name : names) {
        if (bytes.tooMany())
            break;
        const Hdf5Value &value = attributes[name] = valueOf(openAttribute(object, name));
        bytes.count
            += kEntry + name.size() + value.text.size() + value.numbers.size() * sizeof(double);
    }
    return attributes;
}

} // namespace dyncal
