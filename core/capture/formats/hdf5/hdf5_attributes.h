// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

namespace dyncal {

/// How much memory a description has come to: attributes and names may be stored once and count
/// many times.
struct DescribedBytes
{
    std::uint64_t count = 0;
    std::uint64_t most = 0;

    bool tooMany() const { return count > most; }
};

/// All attributes of an object, whatever they are, as long as they are not too many bytes.
Hdf5Attributes readAttributes(hid_t object, DescribedBytes &bytes);

} // namespace dyncal
