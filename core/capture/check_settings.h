// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

namespace dyncal {

/// Recipe section "checks": the limits of findings that a laboratory may set for itself, usually in
/// its profile. The defaults are the program's own limits.
struct CheckSettings
{
    Index saturationRun = 3; ///< equal samples in a row at an extreme that count as saturation
    double flatCodes = 1.0; ///< standard deviation in codes below which a channel is flat
    double leastCodes = 64.0; ///< codes that a step should use at least
    double stepSigmas = 6.0; ///< standard deviations of the noise by which a step must stand out
    double rateMismatch_percent = 0.1; ///< between a stated and a typed sample rate
    double readingFactor = 3.0; ///< between the step that is read and the computed one

    bool operator==(const CheckSettings &) const = default;
};

} // namespace dyncal
