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
    bool wasGauge = false; ///< p1 (side, DUT) or the ambient pressure was added

    double deviation() const { return measured_Pa / predicted_Pa - 1.0; }
};

/// Pressures of all channels whose unit is one of pressure: of a side sensor p1 (absolute ones), p2
/// between the shock and its reflection and p5 behind, of a DUT in the end wall p1 and p5, of the
/// driver p4 before the burst. Gauge readings and those of unknown reference get the recorded
/// ambient pressure, else p1 added. Levels are medians over the middle half of the time that each
/// state lasts; a state shorter than 20 samples is left out.
std::vector<MeasuredPressure> measuredPressures(const Shot &shot, const ShockStates &states,
    const std::vector<Sighting> &sightings, double arrivalAtWall_s, double plateau_s,
    const std::optional<double> &burst_s, const std::optional<double> &p4_Pa);

/// The same readings beside what other states predict.
std::vector<MeasuredPressure> besides(std::vector<MeasuredPressure> measured,
    const ShockStates &states, const std::optional<double> &p4_Pa);

} // namespace dyncal
