// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

#include <string>
#include <vector>

namespace dyncal {

/// A group or dataset being written. All that is written goes into a tree too, as a reader of the
/// file will find it. A call returns true, or a valid object, only if the library reports success.
class Hdf5Scribe
{
public:
    Hdf5Scribe() = default;
    /// The root of an empty file; `tree` is emptied first.
    Hdf5Scribe(hid_t file, Hdf5Tree &tree);

    bool valid() const { return m_handle.valid(); }
    hid_t id() const { return m_handle.id(); }
    bool close() { return m_handle.close(); }

    Hdf5Scribe group(const std::string &name);
    Hdf5Scribe dataset(const std::string &name, const RawSamples &samples);

    /// UTF-8, variable length, scalar.
    bool text(const std::string &name, const std::string &text);
    bool number(const std::string &name, double value);
    bool integer(const std::string &name, int value);
    bool byte(const std::string &name, int value);
    bool numbers(const std::string &name, const std::vector<double> &values);
    bool integers(const std::string &name, const std::vector<int> &values);
    /// Values that are numbers become double attributes, all others text. Identifiers such as
    /// serial numbers stay text ("0042" is not 42).
    bool attributes(const Attributes &attributes);

private:
    Hdf5Scribe(Hdf5Handle handle, Hdf5Tree &tree, Index position);
    Hdf5Object &said() { return m_tree->objects[static_cast<std::size_t>(m_position)]; }
    Hdf5Scribe member(Hdf5Handle handle, const std::string &name);
    bool keep(bool written, const std::string &name, std::vector<double> numbers);

    Hdf5Handle m_handle;
    Hdf5Tree *m_tree = nullptr;
    Index m_position = 0;
};

} // namespace dyncal
