// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/shock/shock_relations.h"
#include "core/shock/shock_velocity.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// One pressure read from a record beside what the relations give; both absolute.
struct MeasuredPressure
{
    std::string region; ///< "p1", "p2", "p4", "p5"
    std::string channel;
    double measured_Pa = 0.0;
    double predicted_Pa = 0.0;
    bool wasGauge = false; ///< the ambient pressure (or p1) was added

    double deviation() const { return measured_Pa / predicted_Pa - 1.0; }
};

/// Pressures of all channels whose unit is one of pressure. Side sensor: p1, p2 between the shock
/// and its reflection, p5 after that; DUT in the end wall: p1 and p5; driver: p4 before the burst.
/// Gauge readings and those of unknown reference get the recorded ambient pressure, else p1 added.
/// Levels are medians over the middle half of the time that each state lasts; where that half has
/// fewer than 20 samples or leaves the record, the state is left out.
std::vector<MeasuredPressure> measuredPressures(const Shot &shot, const ShockStates &states,
    const std::vector<Sighting> &sightings, double arrivalAtWall_s, double plateau_s,
    const std::optional<double> &burst_s, const std::optional<double> &p4_Pa);

/// The same readings, compared with what other states predict.
std::vector<MeasuredPressure> besides(std::vector<MeasuredPressure> measured,
    const ShockStates &states, const std::optional<double> &p4_Pa);

} // namespace dyncal
