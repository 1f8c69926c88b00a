// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <optional>
#include <vector>

namespace dyncal {

/// A smaller copy of the step that arrives later: the shock reflected by something near the sensor.
struct Echo
{
    Index shot = 0; ///< number from 1
    double delay_s = 0.0; ///< after the step
    double u_delay_s = 0.0;
    double relative = 0.0; ///< of the step; negative where it relieves the pressure
    double u_relative = 0.0;
};

/// The earliest echo of every shot that has one, and where the records end because of them.
struct Echoes
{
    std::vector<Echo> ofShots;
    std::optional<double> recordsEnd_s; ///< after the detected start; empty = not shortened
};

} // namespace dyncal
