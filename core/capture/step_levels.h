// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Low, medium and high by the absolute height of each shot's step. Heights belong to different
/// levels where one is at least a tenth above the next lower one; the two widest such gaps count
/// (one: low and high; none: there are no levels). No height gives no level.
std::vector<ShotLevel> levelsByStepHeight(const std::vector<std::optional<double>> &heights);

} // namespace dyncal
