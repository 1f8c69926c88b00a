// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/damped_shots.h"
#include "tests/support/ramp_response.h"

namespace dyncal::testing {

/// Shots of 50 MS/s and 0.3 % noise behind a front (0 = sharp): records begin a quarter of it after
/// it begins, as they are detected.
inline ModelInput shotsBehindFront(double f0_Hz, double zeta, double front_s, std::uint64_t seed,
    const DampedShots &made = {0.003, 0.0, 50e6, 600, 2000})
{
    return dampedShots(
        [=](std::size_t, double t_s) {
            return front_s > 0.0 ? rampResponse(f0_Hz, zeta, front_s, t_s - 0.25 * front_s)
                                 : dampedStep(f0_Hz, zeta, t_s);
        },
        seed, made);
}

} // namespace dyncal::testing
