// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"

#include <optional>

namespace dyncal {

/// The shots as one series, each scaled to the height of the clearest one and weighted by the
/// inverse square of its noise then; the pre-trigger noise likewise (docs/method/order.md). Empty
/// where the shots do not share their shape, so that combining them could hide a mode: the variance
/// of the scaled shots about the combination, both whitened, exceeds that of their pre-trigger
/// noise at the 1 % level. Empty too with fewer than two series, or without a noise record.
std::optional<ModelSeries> combineShots(const ModelInput &input);

} // namespace dyncal
