// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/lvm/lvm_header.h"

#include <span>

namespace dyncal {

struct LvmRate
{
    double sampleRate_Hz = 0.0; ///< 0 = unknown
    double relativePrecision = 0.0; ///< half a unit of the last digit that the rate comes from
    bool contradicted = false; ///< by the X cells, which are no uniform axis or one of another step
    double meanStep = 0.0; ///< of the X cells
};

/// Sample rate of a channel: 1/Delta_X unless the X cells of its samples (empty or all NaN: there
/// are none) contradict it by more than 0.1 % and more than their printed digits (`resolution`) and
/// those of Delta_X explain. Where Delta_X is printed with few digits and the X cells agree, their
/// mean step is taken, as its error is one digit over the whole record. Without Delta_X the X cells
/// decide if they are fine enough.
LvmRate lvmRate(const LvmChannel &channel, std::span<const double> x, double resolution);

} // namespace dyncal
