// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/interval.h"
#include "core/shock/shock_relations.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// x from the diaphragm towards the driven end wall (the driver is at x < 0); t from the burst.
struct TubePoint
{
    double x_m = 0.0;
    double time_s = 0.0;
};

enum class TubeLine {
    Shock,
    ReflectedShock,
    ContactSurface,
    ContactReflection, ///< back from where the reflected shock meets the contact surface
    RarefactionHead, ///< through the driver, reflected at its end, through to the driven end wall
    RarefactionTail,
};

/// One line of the x-t diagram, straight or bent at its points.
struct TubePath
{
    TubeLine line = TubeLine::Shock;
    std::vector<TubePoint> points;
};

/// What ends the plateau at the end wall.
enum class PlateauEnd { ContactSurface, DriverRarefaction, ReflectedShock };

const char *plateauEndName(
    PlateauEnd end); ///< "contact-surface", "driver-rarefaction", "reflected-shock"

/// Geometry and driver of one shot, as far as they are known.
struct TubeGeometry
{
    double drivenLength_m = 0.0;
    std::optional<double> driverLength_m;
    std::optional<GasState> driver; ///< region 4
    Gas driverGas;
};

/// Waves of one shot: an ideal shock tube, opened at once, plane waves.
struct TubeWaves
{
    TubeGeometry geometry;
    std::vector<TubePath> paths; ///< the rarefaction only where the driver is known
    double shockAtWall_s = 0.0; ///< from the burst
    double contactReturn_s = 0.0; ///< from the step at the wall: reflected shock's return
    std::optional<double> rarefactionReturn_s; ///< from the step: driver rarefaction's arrival
    double plateau_s = 0.0; ///< the earlier of the two
    PlateauEnd plateauEnd = PlateauEnd::ContactSurface;
    double driverGasFront_s = 0.0; ///< from the step: driver gas at the wall, were it not stopped
};

/// Lengths above 0. The rarefaction's head runs into the driver at a4, is reflected at its end,
/// comes back through the fan (C+ characteristic: t = L4/a4 (a4/a3)^((g+1)/(2(g-1))) at its tail),
/// region 3, region 2 (or, where the reflected shock has stopped the contact surface before, the
/// driver gas at rest behind the transmitted shock) and region 5 (docs/method/shock.md).
TubeWaves tubeWaves(const ShockStates &states, const TubeGeometry &geometry);

/// What one record of the shot shows, on the record's own axis.
struct TubeSensor
{
    std::string channel;
    double distance_m = 0.0; ///< to the end wall
    std::optional<double> arrival_s; ///< seen
    double expected_s = 0.0; ///< of the shock by the diagram
    double driverGas_s = 0.0; ///< of the contact surface, if nothing stopped it
};

/// All that an x-t diagram draws. A time of `waves` plus `burst_s` is a time of the record.
struct TubeDiagram
{
    TubeWaves waves;
    double burst_s = 0.0;
    std::vector<TubeSensor> sensors; ///< with the end wall last
    Interval plateau_s{}; ///< usable part of the step at the end wall, guard taken off
};

/// `arrivalAtWall_s` on the record's axis.
TubeDiagram tubeDiagram(const TubeWaves &waves, const ShockStates &states, double arrivalAtWall_s,
    std::vector<TubeSensor> sensors, double usable_s);

} // namespace dyncal
