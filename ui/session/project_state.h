// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/project/recipe.h"

#include <memory>

namespace dyncal {

/// What one calibration job is made of and what undo restores. The recordings are shared and never
/// changed, so a copy costs only the recipe. The file list is `captures->inputs`.
struct ProjectState
{
    std::shared_ptr<const CaptureSet> captures = std::make_shared<const CaptureSet>();
    Recipe recipe;

    bool hasShots() const { return !captures->shots.empty(); }
    bool operator==(const ProjectState &) const = default;
};

} // namespace dyncal
