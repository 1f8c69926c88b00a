// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/formats/hdf5/hdf5_tree.h"

#include <string>

namespace dyncal {

/// The sentence for a dataset that cannot be samples (CAP-018).
tl::unexpected<Error> hdf5ObstacleError(
    const std::string &path, const std::string &name, const Hdf5Dataset &dataset);

} // namespace dyncal
