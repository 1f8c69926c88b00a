// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_handle.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

namespace dyncal {

/// Memory of a description so far; the file may store an attribute or name once and use it many
/// times.
struct DescribedBytes
{
    std::uint64_t count = 0;
    std::uint64_t most = 0;

    bool tooMany() const { return count > most; }
};

/// All attributes of an object, unless they have too many bytes.
Hdf5Attributes readAttributes(hid_t object, DescribedBytes &bytes);

} // namespace dyncal
