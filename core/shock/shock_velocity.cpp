// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_velocity.h"

#include "core/base/number_text.h"
#include "core/shock/side_arrival.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

/// Where and when the shock was seen.
struct Sighting
{
    double distance_m = 0.0; ///< to the end wall
    double u_distance_m = 0.0;
    double time_s = 0.0;
    std::string channel;
};

VelocityEstimate missing(Message message)
{
    VelocityEstimate estimate;
    estimate.missing = std::move(message);
    return estimate;
}

const Channel *channelOf(const Shot &shot, const std::string &nameOrRole)
{
    const auto named = std::find_if(shot.channels.begin(), shot.channels.end(),
        [&](const Channel &channel) { return channel.name == nameOrRole; });
    if (named != shot.channels.end())
        return &*named;
    const ChannelRole role = channelRoleFromName(nameOrRole);
    return role == ChannelRole::Other ? nullptr : shot.channelWithRole(role);
}

/// The recipe's sensors, or the one the tube's description stands for.
std::vector<ArrivalSensor> arrivalSensors(
    const CaptureSet &set, const Shot &shot, const ShockSettings &settings)
{
    if (!settings.arrivalSensors.empty())
        return settings.arrivalSensors;
    const Channel *side = shot.channelWithRole(ChannelRole::DrivenSide);
    const auto distance_m = set.tubeNumber("endflange_to_sensor2_m");
    if (side == nullptr || !distance_m || !(*distance_m > 0.0))
        return {};
    const double u_m = set.tubeNumber("u_endflange_to_sensor2_m").value_or(0.0);
    return {{side->name, *distance_m, u_m > 0.0 ? u_m : 0.0}};
}

Message noSensorMessage(const Shot &shot)
{
    if (shot.channelWithRole(ChannelRole::DrivenSide) != nullptr)
        return {DYNCAL_TEXT("core",
                    "The pressure step is not determined: the shock velocity is unknown, because "
                    "the distance from the side sensor to the end wall is not recorded; enter the "
                    "distance, the velocity or the step itself."),
            {}};
    return {DYNCAL_TEXT("core",
                "The pressure step is not determined: the shock velocity is unknown, because no "
                "channel marks the passing of the shock; enter the velocity or the step itself."),
        {}};
}

Message noArrivalMessage(const std::string &channel)
{
    return {DYNCAL_TEXT("core",
                "The pressure step is not determined: the shock velocity is unknown, because no "
                "arrival is found in the channel '%1'; enter the velocity or the step itself."),
        {channel}};
}

std::string dutName(const Shot &shot)
{
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    return dut != nullptr ? dut->name : "DUT";
}

/// One sighting per sensor, or the sentence that says which one is missing.
tl::expected<std::vector<Sighting>, Message> sightings(const CaptureSet &set, const Shot &shot,
    const std::optional<double> &dutArrival_s, const ShockSettings &settings)
{
    const std::vector<ArrivalSensor> sensors = arrivalSensors(set, shot, settings);
    if (sensors.empty())
        return tl::unexpected(noSensorMessage(shot));
    std::vector<Sighting> seen;
    const bool dutCounts = settings.dutPosition == kEndWall;
    for (const ArrivalSensor &sensor : sensors) {
        const Channel *channel = channelOf(shot, sensor.channel);
        const auto time_s = channel != nullptr
            ? sideArrival_s(*channel, dutCounts ? dutArrival_s : std::nullopt)
            : std::nullopt;
        if (!time_s)
            return tl::unexpected(noArrivalMessage(sensor.channel));
        seen.push_back({sensor.distanceToEndWall_m, sensor.u_distance_m, *time_s, sensor.channel});
    }
    if (dutCounts && dutArrival_s && std::isfinite(*dutArrival_s))
        seen.push_back({0.0, 0.0, *dutArrival_s, dutName(shot)});
    return seen;
}

Message tooFewMessage(bool atEndWall)
{
    if (atEndWall)
        return {DYNCAL_TEXT("core",
                    "The pressure step is not determined: the shock velocity is unknown, because "
                    "the arrival at the DUT is not known; enter the velocity or the step itself."),
            {}};
    return {DYNCAL_TEXT("core",
                "The pressure step is not determined: the shock velocity is unknown, because a DUT "
                "in the side wall needs two arrival sensors; enter the velocity or the step "
                "itself."),
        {}};
}

/// Slope of distance travelled over time: least squares of the times on the distances.
std::optional<double> velocityOf(const std::vector<Sighting> &seen)
{
    const double n = static_cast<double>(seen.size());
    double meanX = 0.0;
    double meanT = 0.0;
    for (const Sighting &s : seen) {
        meanX += s.distance_m / n;
        meanT += s.time_s / n;
    }
    double xx = 0.0;
    double xt = 0.0;
    for (const Sighting &s : seen) {
        xx += (s.distance_m - meanX) * (s.distance_m - meanX);
        xt += (s.distance_m - meanX) * (s.time_s - meanT);
    }
    if (!(xx > 0.0))
        return std::nullopt;
    return -xx / xt; // the shock runs towards smaller distances; infinite for equal times
}

/// u(W)/W from the distances: each weighs with its lever (x_i - mean x) / sum (x - mean x)^2.
double relativeDistanceUncertainty(const std::vector<Sighting> &seen)
{
    double mean = 0.0;
    for (const Sighting &s : seen)
        mean += s.distance_m / static_cast<double>(seen.size());
    double sum = 0.0;
    double variance = 0.0;
    for (const Sighting &s : seen) {
        const double lever = s.distance_m - mean;
        sum += lever * lever;
        variance += lever * lever * s.u_distance_m * s.u_distance_m;
    }
    return std::sqrt(variance) / sum;
}

Error wrongOrder(const Sighting &farthest, const Sighting &nearest)
{
    return {ErrorKind::DataBlocked,
        Message{DYNCAL_TEXT("core",
                    "The shock reaches '%1' %2 after '%3', which is farther down the tube: check "
                    "whether the two channels are swapped (CAP-010), and their distances."),
            {farthest.channel, numberWithUnit(farthest.time_s - nearest.time_s, "s", 3),
                nearest.channel}},
        "SHK-001"};
}

} // namespace

VelocityEstimate estimateVelocity(const CaptureSet &set, const Shot &shot,
    const std::optional<double> &dutArrival_s, const ShockSettings &settings)
{
    VelocityEstimate estimate;
    if (settings.velocity_m_s) {
        estimate.velocity_m_s = settings.velocity_m_s;
        return estimate;
    }
    auto found = sightings(set, shot, dutArrival_s, settings);
    if (!found)
        return missing(std::move(found.error()));
    std::stable_sort(found->begin(), found->end(),
        [](const Sighting &a, const Sighting &b) { return a.distance_m > b.distance_m; });
    const Sighting &farthest = found->front();
    const Sighting &nearest = found->back();
    estimate.arrival_s = farthest.time_s;
    estimate.distance_m = farthest.distance_m;
    if (found->size() < 2 || farthest.distance_m == nearest.distance_m) {
        estimate.missing = tooFewMessage(settings.dutPosition == kEndWall);
        return estimate;
    }
    if (farthest.time_s >= nearest.time_s) {
        estimate.problem = wrongOrder(farthest, nearest);
        return estimate;
    }
    estimate.velocity_m_s = velocityOf(*found);
    estimate.relativeDistanceUncertainty = relativeDistanceUncertainty(*found);
    return estimate;
}

} // namespace dyncal
