// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/synthesis/shot_plan.h"

namespace dyncal {

/// The attributes of /truth/shot_...: sensor, shock and what the defects did (docs/simulator.md).
ShotTruth truthOf(
    const SimulationSettings &settings, const ShotPlan &plan, const Digitizer &digitizer);

} // namespace dyncal
