// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/measured_pressures.h"

#include "core/shock/pressure_units.h"
#include "core/shock/side_arrival.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kLeastSamples = 20.0;
constexpr double kBeforeShare = 0.5; ///< of the record before the shock

/// Reads one channel in absolute pascals.
class PressureReader
{
public:
    PressureReader(const Channel &channel, double pascals, double ambient_Pa,
        std::vector<MeasuredPressure> &list)
        : m_channel(channel)
        , m_pascals(pascals)
        , m_offset_Pa(channel.reference == PressureReference::Absolute ? 0.0 : ambient_Pa)
        , m_list(list)
    {
    }

    void add(const char *region, double begin_s, double end_s, double predicted_Pa)
    {
        const double quarter_s = 0.25 * (end_s - begin_s);
        begin_s += quarter_s;
        end_s -= quarter_s;
        if (!((end_s - begin_s) * m_channel.sampleRate_Hz >= kLeastSamples)
            || begin_s < m_channel.t0_s || end_s > m_channel.t0_s + m_channel.duration_s())
            return;
        if (const auto level = medianBetween(m_channel, begin_s, end_s))
            m_list.push_back({region, m_channel.name, *level * m_pascals + m_offset_Pa,
                predicted_Pa, m_offset_Pa != 0.0});
    }

    void addBefore(const char *region, double arrival_s, double predicted_Pa)
    {
        const double length_s = arrival_s - m_channel.t0_s;
        add(region, arrival_s - kBeforeShare * length_s, arrival_s - 0.01 * length_s, predicted_Pa);
    }

private:
    const Channel &m_channel;
    double m_pascals;
    double m_offset_Pa;
    std::vector<MeasuredPressure> &m_list;
};

} // namespace

std::vector<MeasuredPressure> measuredPressures(const Shot &shot, const ShockStates &states,
    const std::vector<Sighting> &sightings, double arrivalAtWall_s, double plateau_s,
    const std::optional<double> &burst_s, const std::optional<double> &p4_Pa)
{
    std::vector<MeasuredPressure> list;
    const double p1_Pa = states.driven.pressure_Pa;
    const double ambient_Pa = std::isfinite(shot.environment.ambientPressure_Pa)
        ? shot.environment.ambientPressure_Pa
        : p1_Pa;
    const double p5_Pa = states.reflected.pressure_Pa;
    for (const Sighting &sighting : sightings) {
        const Channel *channel = shot.channelCalled(sighting.channel);
        const auto pascals = channel ? pascalsPer(channel->unit) : std::nullopt;
        if (!pascals)
            continue;
        PressureReader reader(*channel, *pascals, ambient_Pa, list);
        reader.addBefore("p1", sighting.time_s, p1_Pa);
        if (sighting.distance_m > 0.0) {
            const double back_s
                = arrivalAtWall_s + sighting.distance_m / states.reflectedVelocity_m_s;
            reader.add("p2", sighting.time_s, back_s, states.shocked.pressure_Pa);
            // The disturbance that ends the plateau reaches the wall first and this sensor later.
            reader.add("p5", back_s,
                arrivalAtWall_s + plateau_s + sighting.distance_m / states.reflected.soundSpeed_m_s,
                p5_Pa);
        } else {
            reader.add("p5", arrivalAtWall_s, arrivalAtWall_s + plateau_s, p5_Pa);
        }
    }
    const Channel *driver = shot.channelWithRole(ChannelRole::Driver);
    const auto pascals = driver ? pascalsPer(driver->unit) : std::nullopt;
    if (pascals && p4_Pa && burst_s)
        PressureReader(*driver, *pascals, ambient_Pa, list).addBefore("p4", *burst_s, *p4_Pa);
    return list;
}

std::vector<MeasuredPressure> besides(std::vector<MeasuredPressure> measured,
    const ShockStates &states, const std::optional<double> &p4_Pa)
{
    for (MeasuredPressure &m : measured) {
        if (m.region == "p1")
            m.predicted_Pa = states.driven.pressure_Pa;
        else if (m.region == "p2")
            m.predicted_Pa = states.shocked.pressure_Pa;
        else if (m.region == "p5")
            m.predicted_Pa = states.reflected.pressure_Pa;
        else
            m.predicted_Pa = p4_Pa.value_or(m.predicted_Pa);
    }
    return measured;
}

} // namespace dyncal
