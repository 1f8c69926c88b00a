// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/capture/formats/hdf5_handle.h"
#include "core/capture/formats/hdf5_tree.h"

#include <string>
#include <vector>

namespace dyncal {

// Writing: true if everything, including the close, succeeded.

/// UTF-8, variable length, scalar.
bool writeTextAttribute(hid_t object, const std::string &name, const std::string &text);
bool writeNumberAttribute(hid_t object, const std::string &name, double value);
bool writeIntegerAttribute(hid_t object, const std::string &name, int value);
bool writeByteAttribute(hid_t object, const std::string &name, int value);
bool writeNumbersAttribute(
    hid_t object, const std::string &name, const std::vector<double> &values);
bool writeIntegersAttribute(hid_t object, const std::string &name, const std::vector<int> &values);

/// Values that are numbers become double attributes, all others text. Identifiers such as serial
/// numbers stay text ("0042" is not 42).
bool writeAttributes(hid_t object, const Attributes &attributes);

/// All attributes of an object, whatever they are.
Hdf5Attributes readAttributes(hid_t object);

} // namespace dyncal
