// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/tube_waves.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr int kFanPoints = 24; ///< of the bent part of the head in the diagram

/// Where and when two straight paths meet: x = a.x + va (t - a.t) and the same for b.
TubePoint meeting(const TubePoint &a, double va_m_s, const TubePoint &b, double vb_m_s)
{
    const double time_s
        = (b.x_m - a.x_m + va_m_s * a.time_s - vb_m_s * b.time_s) / (va_m_s - vb_m_s);
    return {a.x_m + va_m_s * (time_s - a.time_s), time_s};
}

/// When a straight path from `from` reaches x.
TubePoint reached(const TubePoint &from, double velocity_m_s, double x_m)
{
    return {x_m, from.time_s + (x_m - from.x_m) / velocity_m_s};
}

/// Driver gas behind the transmitted shock, which the reflected shock sends into region 3 and which
/// stops the gas there (velocity u3). Its velocity along the tube is -`shock_m_s`.
struct StoppedDriver
{
    double soundSpeed_m_s = 0.0;
    double shock_m_s = 0.0;
};

StoppedDriver stoppedDriver(const Gas &gas, double a3_m_s, double u3_m_s)
{
    // M - 1/M = (g+1)/2 u/a of a shock that changes the velocity by u.
    const double half = (gas.gamma + 1.0) / 4.0 * u3_m_s / a3_m_s;
    const double mach = half + std::hypot(half, 1.0);
    const double ratio = 1.0 + 2.0 * gas.gamma / (gas.gamma + 1.0) * (mach * mach - 1.0);
    const double g = (gas.gamma + 1.0) / (gas.gamma - 1.0);
    const double temperatureRatio = ratio * (g + ratio) / (1.0 + g * ratio);
    return {a3_m_s * std::sqrt(temperatureRatio), mach * a3_m_s - u3_m_s};
}

/// The lines of one shot as they meet.
class Waves
{
public:
    Waves(const ShockStates &states, const TubeGeometry &geometry)
        : m_states(states)
    {
        m_waves.geometry = geometry;
        const double length_m = geometry.drivenLength_m;
        m_wall = {length_m, length_m / states.velocity_m_s};
        m_contact = meeting(
            {0.0, 0.0}, states.shocked.velocity_m_s, m_wall, -states.reflectedVelocity_m_s);
        m_waves.shockAtWall_s = m_wall.time_s;
        addDrivenLines();
        if (geometry.driver && geometry.driverLength_m)
            addRarefaction();
        m_waves.driverGasFront_s = length_m / states.shocked.velocity_m_s - m_waves.shockAtWall_s;
    }

    TubeWaves take() { return std::move(m_waves); }

private:
    void add(TubeLine line, std::vector<TubePoint> points)
    {
        m_waves.paths.push_back({line, std::move(points)});
    }

    void addDrivenLines()
    {
        const TubePoint back = reached(m_contact, m_states.reflected.soundSpeed_m_s, m_wall.x_m);
        m_waves.contactReturn_s = back.time_s - m_wall.time_s;
        m_waves.plateau_s = m_waves.contactReturn_s;
        add(TubeLine::Shock, {{0.0, 0.0}, m_wall});
        add(TubeLine::ReflectedShock, {m_wall, m_contact});
        // The reflected shock stops it (to a good approximation).
        add(TubeLine::ContactSurface, {{0.0, 0.0}, m_contact, {m_contact.x_m, back.time_s}});
        add(TubeLine::ContactReflection, {m_contact, back});
    }

    void addRarefaction()
    {
        const GasState &driver = *m_waves.geometry.driver;
        const double g = m_waves.geometry.driverGas.gamma;
        const double a4_m_s = driver.soundSpeed_m_s;
        const double u3_m_s = m_states.shocked.velocity_m_s;
        const double a3_m_s = a4_m_s - 0.5 * (g - 1.0) * u3_m_s; // Riemann invariant
        if (!(a3_m_s > 0.0))
            return; // no driver pressure makes this shock
        const double L4_m = *m_waves.geometry.driverLength_m;
        const double reflected_s = L4_m / a4_m_s;
        const double exponent = (g + 1.0) / (2.0 * (g - 1.0));
        std::vector<TubePoint> head{{0.0, 0.0}};
        for (int i = 0; i <= kFanPoints; ++i) { // through the fan: x/t = u - a, a falls to a3
            const double a_m_s = a4_m_s + (a3_m_s - a4_m_s) * i / kFanPoints;
            const double u_m_s = 2.0 / (g - 1.0) * (a4_m_s - a_m_s);
            const double t_s = reflected_s * std::pow(a4_m_s / a_m_s, exponent);
            head.push_back({(u_m_s - a_m_s) * t_s, t_s});
        }
        const TubePoint fanEnd = head.back();
        add(TubeLine::RarefactionTail, {{0.0, 0.0}, fanEnd});
        follow(head, fanEnd, u3_m_s, a3_m_s);
        m_waves.rarefactionReturn_s = head.back().time_s - m_wall.time_s;
        if (*m_waves.rarefactionReturn_s < m_waves.plateau_s) {
            m_waves.plateau_s = *m_waves.rarefactionReturn_s;
            m_waves.plateauEnd = PlateauEnd::DriverRarefaction;
        }
        add(TubeLine::RarefactionHead, std::move(head));
    }

    /// From the end of the fan to the wall.
    void follow(std::vector<TubePoint> &head, const TubePoint &fanEnd, double u3_m_s, double a3_m_s)
    {
        const double a5_m_s = m_states.reflected.soundSpeed_m_s;
        const TubePoint atContact = meeting(fanEnd, u3_m_s + a3_m_s, {0.0, 0.0}, u3_m_s);
        if (atContact.time_s < m_contact.time_s) {
            head.push_back(atContact);
            const double along_m_s = u3_m_s + m_states.shocked.soundSpeed_m_s;
            const TubePoint atShock
                = meeting(atContact, along_m_s, m_wall, -m_states.reflectedVelocity_m_s);
            if (atShock.x_m > m_wall.x_m) { // overtakes the shock itself: no plateau to speak of
                head.push_back(reached(atContact, along_m_s, m_wall.x_m));
                return;
            }
            head.push_back(atShock);
            head.push_back(reached(atShock, a5_m_s, m_wall.x_m));
            return;
        }
        const StoppedDriver stopped = stoppedDriver(m_waves.geometry.driverGas, a3_m_s, u3_m_s);
        const TubePoint atShock = meeting(fanEnd, u3_m_s + a3_m_s, m_contact, -stopped.shock_m_s);
        head.push_back(atShock);
        head.push_back(reached(atShock, stopped.soundSpeed_m_s, m_contact.x_m));
        head.push_back(reached(head.back(), a5_m_s, m_wall.x_m));
    }

    const ShockStates &m_states;
    TubeWaves m_waves;
    TubePoint m_wall; ///< the shock's arrival at the end wall
    TubePoint m_contact; ///< the reflected shock's meeting with the contact surface
};

} // namespace

const char *plateauEndName(PlateauEnd end)
{
    switch (end) {
    case PlateauEnd::ContactSurface:
        return "contact-surface";
    case PlateauEnd::DriverRarefaction:
        return "driver-rarefaction";
    case PlateauEnd::ReflectedShock:
        return "reflected-shock";
    }
    return "";
}

TubeWaves tubeWaves(const ShockStates &states, const TubeGeometry &geometry)
{
    return Waves(states, geometry).take();
}

TubeDiagram tubeDiagram(const TubeWaves &waves, const ShockStates &states, double arrivalAtWall_s,
    std::vector<TubeSensor> sensors, double usable_s)
{
    TubeDiagram diagram{waves, arrivalAtWall_s - waves.shockAtWall_s, {}, {}};
    for (TubeSensor &sensor : sensors) {
        const double x_m = waves.geometry.drivenLength_m - sensor.distance_m;
        sensor.expected_s = diagram.burst_s + x_m / states.velocity_m_s;
        sensor.driverGas_s = diagram.burst_s + x_m / states.shocked.velocity_m_s;
    }
    std::stable_sort(sensors.begin(), sensors.end(),
        [](const TubeSensor &a, const TubeSensor &b) { return a.distance_m > b.distance_m; });
    diagram.sensors = std::move(sensors);
    diagram.plateau_s = {arrivalAtWall_s, arrivalAtWall_s + usable_s};
    return diagram;
}

} // namespace dyncal
