// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/auto_value.h"
#include "core/base/index.h"

#include <string>
#include <vector>

namespace dyncal {

/// A mode that is not the sensor's: fitted to each shot separately and left out of the model.
struct NuisanceMode
{
    std::vector<double> frequency_Hz; ///< one, or one per shot of the capture set
    Index shot = 0; ///< where the one frequency was read; 0 = the first shot used
    bool isTube = true; ///< set off by the step, and moves with the sound speed of the gas
    std::string label; ///< "transverse (1,1)"
    std::string reason;

    bool operator==(const NuisanceMode &) const = default;
};

/// The operator's note on an order that is compared.
struct OrderNote
{
    Index order = 0;
    std::string note;

    bool operator==(const OrderNote &) const = default;
};

/// Recipe section "realization".
struct RealizationSettings
{
    Auto<Index> order; ///< auto = the suggested order
    Index maxOrder = 120; ///< singular values and orders offered at most
    Auto<Index> rows; ///< block rows r of the Hankel matrix; auto = floor(N/2) - 1
    bool refine = true; ///< nonlinear least squares on the poles after the realisation
    double stableFrequency = 0.01; ///< largest relative change of a stable pole's frequency
    double stableDamping = 0.05; ///< largest relative change of its damping ratio
    std::vector<Index> candidates; ///< orders pinned for comparison; no result depends on them
    std::vector<OrderNote> candidateNotes; ///< one per order at most; no result depends on them
    std::string adoptedReason; ///< why this order was adopted; printed, not computed with

    std::vector<NuisanceMode> nuisanceModes;

    bool operator==(const RealizationSettings &) const = default;
};

} // namespace dyncal
