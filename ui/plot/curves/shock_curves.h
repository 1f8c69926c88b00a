// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_conditions.h"
#include "ui/plot/curves/signal_curves.h"
#include "ui/plot/values/plot_content.h"

namespace dyncal {

/// x-t diagram of the tube from the shot's own numbers: waves, sensors, what they saw, and the
/// usable plateau at the end wall. Distances from the diaphragm, times of the record. Empty without
/// a diagram.
PlotContent tubeDiagramCurves(const ShockConditions &shot);

/// The record of one channel around the arrival of the shock there: the levels that the arrival was
/// judged by, and the arrival of the driver gas, as far as they are known. `distance_m` is the
/// channel's to the end wall (0: the DUT in it).
PlotContent arrivalCurves(const Channel &channel, const ShockConditions &shot, double distance_m,
    const EnvelopeSource &envelopeOf);

/// Marks the frequencies at which the tube, not the sensor, may ring: (m,n) across the tube, "5.1"
/// its wall, "5.2" its gas before the burst, "a5" and "mix" behind the reflected shock. First modes
/// are labelled. Those below the plot's first frequency are left out.
void addTubeModes(PlotContent &content, const ShockConditions &shot);

} // namespace dyncal
