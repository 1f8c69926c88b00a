// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

namespace dyncal {

/// Recipe section "pca".
struct ComponentSettings
{
    Index components = 1; ///< kept in the reconstructions
    bool centre = false; ///< subtract the mean over shots first
    Index residualLags = 500;
    double residualConfidence = 0.99;

    bool operator==(const ComponentSettings &) const = default;
};

} // namespace dyncal
