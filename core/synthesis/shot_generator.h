// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/synthesis/simulation_settings.h"

#include <vector>

namespace dyncal {

struct SimulatedCapture
{
    CaptureSet set;
    std::vector<ShotTruth>
        truth; ///< f0_Hz, zeta, arrival_s, step_Pa, velocity_m_s, sensitivity, ...
};

/// Simulates whole shots. Identical counts on every amd64 Debian 12 for the same settings.
/// Fails (Usage) on settings that make no sense, naming the value and the range.
Result<SimulatedCapture> simulateShots(
    const SimulationSettings &settings, const JobControl &control = {});

} // namespace dyncal
