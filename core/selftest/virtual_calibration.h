// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"

#include <array>
#include <stop_token>

namespace dyncal {

/// What is compared with the truth of a virtual calibration.
enum class VirtualQuantity : Index { Sensitivity, Frequency, Damping, Magnitude };
inline constexpr std::size_t kVirtualQuantities = 4;

/// One stated value against the truth.
struct VirtualError
{
    double overU = 0.0; ///< (stated - true) over the stated u, k = 1
    bool isInside = false; ///< |stated - true| <= the stated U
};

/// NaN and outside where something was not stated.
using VirtualErrors = std::array<VirtualError, kVirtualQuantities>;

/// A sensor of second order in a shock tube, both drawn from the numbers of `run` (from 1), two
/// shots recorded with noise by a laboratory whose distances, temperature, pressure and gas err as
/// it states; calibrated by the pipeline, and compared with what was drawn. The records and the
/// pressure step follow from closed forms of their own. `stop` ends it early, with nothing stated.
VirtualErrors virtualCalibration(Index run, const std::stop_token &stop = {});

} // namespace dyncal
