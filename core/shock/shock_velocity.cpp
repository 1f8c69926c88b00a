// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_velocity.h"

#include "core/base/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

/// An unknown delay of the 50 % crossing, in rise times: from 0 (a diaphragm that the front sweeps)
/// to this (a damped sensor); it is never negative.
constexpr double kLargestDelay = 0.85;

VelocityEstimate missing(Message message)
{
    VelocityEstimate estimate;
    estimate.missing = std::move(message);
    return estimate;
}

Message noSensorMessage(const Shot &shot)
{
    if (shot.channelWithRole(ChannelRole::DrivenSide) != nullptr)
        return {
            DYNCAL_TEXT("core",
                "The pressure step is not determined: the shock velocity is unknown, because the distance from the side sensor to the end wall is not recorded; enter the distance, the velocity or the step itself."),
            {}};
    return {
        DYNCAL_TEXT("core",
            "The pressure step is not determined: the shock velocity is unknown, because no channel marks the passing of the shock; enter the velocity or the step itself."),
        {}};
}

Message noArrivalMessage(const std::string &channel)
{
    return {
        DYNCAL_TEXT("core",
            "The pressure step is not determined: the shock velocity is unknown, because no arrival is found in the channel '%1'; enter the velocity or the step itself."),
        {channel}};
}

std::string dutName(const Shot &shot)
{
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    return dut != nullptr ? dut->name : "DUT";
}

/// Typed, or found in the record.
std::optional<Sighting> sightingOf(
    const ArrivalSensor &sensor, const std::vector<SeenArrival> &arrivals)
{
    const auto known = std::find_if(arrivals.begin(), arrivals.end(),
        [&](const SeenArrival &arrival) { return arrival.channel == sensor.channel; });
    const SideArrival *found = known != arrivals.end() && known->found ? &*known->found : nullptr;
    if (found == nullptr && !sensor.arrival_s)
        return std::nullopt;
    const bool typed = sensor.arrival_s.has_value();
    Sighting seen;
    seen.channel = sensor.channel;
    seen.distance_m = sensor.distanceToEndWall_m;
    seen.u_distance_m = sensor.u_distance_m;
    const double rise_s = found != nullptr ? found->rise_s : 0.0;
    const double delay_s = sensor.delay_s.value_or(0.5 * kLargestDelay * rise_s);
    seen.time_s = (typed ? *sensor.arrival_s : found->time_s) - delay_s;
    // A time read with a cursor is no better than the search, and has the same delay.
    const bool stated = typed && sensor.u_arrival_s > 0.0;
    seen.u_time_s = stated || found == nullptr ? sensor.u_arrival_s : found->u_time_s;
    seen.u_delay_s = sensor.delay_s ? sensor.u_delay_s : kLargestDelay * rise_s / std::sqrt(12.0);
    return seen;
}

Sighting dutSighting(const Shot &shot, const DutArrival &arrival)
{
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    Sighting seen;
    seen.channel = dutName(shot);
    seen.time_s = arrival.time_s;
    seen.u_time_s = arrival.u_time_s > 0.0 ? arrival.u_time_s : 0.0;
    if (seen.u_time_s == 0.0 && dut != nullptr && dut->sampleRate_Hz > 0.0)
        seen.u_time_s = 1.0 / dut->sampleRate_Hz / std::sqrt(12.0);
    seen.isDut = true;
    return seen;
}

/// One sighting per sensor, or the sentence that says which one is missing.
tl::expected<std::vector<Sighting>, Message> sightings(const CaptureSet &set, Index number,
    const std::optional<DutArrival> &dutArrival, const std::vector<SeenArrival> &arrivals,
    const ShockSettings &settings)
{
    const Shot &shot = set.shots.at(static_cast<std::size_t>(number - 1));
    const std::vector<ArrivalSensor> sensors = arrivalSensors(set, number, settings);
    if (sensors.empty())
        return tl::unexpected(noSensorMessage(shot));
    std::vector<Sighting> seen;
    for (const ArrivalSensor &sensor : sensors) {
        auto sighting = sightingOf(sensor, arrivals);
        if (!sighting)
            return tl::unexpected(noArrivalMessage(sensor.channel));
        seen.push_back(std::move(*sighting));
    }
    if (settings.dutPosition == kEndWall && dutArrival && settings.useDutArrival
        && std::isfinite(dutArrival->time_s))
        seen.push_back(dutSighting(shot, *dutArrival));
    return seen;
}

Message tooFewMessage(bool atEndWall)
{
    if (atEndWall)
        return {
            DYNCAL_TEXT("core",
                "The pressure step is not determined: the shock velocity is unknown, because the arrival at the DUT is not known; enter the velocity or the step itself."),
            {}};
    return {
        DYNCAL_TEXT("core",
            "The pressure step is not determined: the shock velocity is unknown, because a DUT in the side wall needs two arrival sensors; enter the velocity or the step itself."),
        {}};
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
        Message{
            DYNCAL_TEXT("core",
                "The shock reaches '%1' %2 after '%3', which is farther down the tube: check whether the two channels are swapped (CAP-010), and their distances."),
            {farthest.channel, numberWithUnit(farthest.time_s - nearest.time_s, "s", 3),
                nearest.channel}},
        "SHK-001"};
}

/// Exchanges the roles of a DUT and a side sensor that were mixed up.
std::optional<Correction> exchangeRoles(
    const Shot &shot, const Sighting &farthest, const Sighting &nearest)
{
    const Channel *side = shot.channelCalled(farthest.channel);
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    if (side == nullptr || dut == nullptr || !nearest.isDut)
        return std::nullopt;
    const nlohmann::json roles{
        {side->name, channelRoleName(ChannelRole::Dut)}, {dut->name, channelRoleName(side->role)}};
    return Correction{
        .label = {DYNCAL_TEXT("core", "Exchange '%1' and '%2'"), {side->name, dut->name}},
        .key = "import.channels",
        .value = roles.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

Attenuation attenuationOf(const std::string &word)
{
    if (word == "none")
        return Attenuation::None;
    return word == "linear" ? Attenuation::Linear : Attenuation::Automatic;
}

VelocityEstimate withFit(VelocityEstimate estimate, Result<VelocityFit> fit)
{
    if (!fit) {
        estimate.problem = std::move(fit.error());
        return estimate;
    }
    estimate.velocity_m_s = fit->velocity_m_s;
    estimate.fit = std::move(*fit);
    return estimate;
}

} // namespace

std::vector<ArrivalSensor> arrivalSensors(
    const CaptureSet &set, Index shot, const ShockSettings &settings)
{
    const auto at = static_cast<std::size_t>(shot - 1);
    if (!settings.arrivalSensors.empty()) {
        std::vector<ArrivalSensor> sensors = settings.arrivalSensors;
        for (ArrivalSensor &sensor : sensors) {
            if (at < sensor.shotArrival_s.size())
                sensor.arrival_s = sensor.shotArrival_s[at];
        }
        return sensors;
    }
    const Channel *side = set.shots.at(at).channelWithRole(ChannelRole::DrivenSide);
    const auto distance_m = set.tubeNumber("endflange_to_sensor2_m");
    if (side == nullptr || !distance_m || !(*distance_m > 0.0))
        return {};
    const double u_m = set.tubeNumber("u_endflange_to_sensor2_m").value_or(0.0);
    return {{side->name, *distance_m, u_m > 0.0 ? u_m : 0.0}};
}

std::vector<std::string> arrivalChannels(const ShockSettings &settings)
{
    std::vector<std::string> names;
    for (const ArrivalSensor &sensor : settings.arrivalSensors)
        names.push_back(sensor.channel);
    return names;
}

std::vector<SeenArrival> seenArrivals(const CaptureSet &set, Index shot,
    const ShockSettings &settings, const RecordStarts &starts,
    const std::optional<double> &dutStart_s)
{
    const Shot &records = set.shots.at(static_cast<std::size_t>(shot - 1));
    const auto reflectionFree_s = settings.dutPosition == kEndWall ? dutStart_s : std::nullopt;
    std::vector<SeenArrival> arrivals;
    for (const ArrivalSensor &sensor : arrivalSensors(set, shot, settings)) {
        const Channel *channel = records.channelCalled(sensor.channel);
        const DetectedStart *start = starts.of(set, shot, channel);
        arrivals.push_back({sensor.channel,
            start != nullptr ? sideArrival(*channel, *start, reflectionFree_s) : std::nullopt});
        if (auto &found = arrivals.back().found; found && reflectionFree_s)
            found->back = returnPassage(*channel, *found, *reflectionFree_s);
    }
    return arrivals;
}

VelocityEstimate estimateVelocity(const CaptureSet &set, Index shot,
    const std::optional<DutArrival> &dutArrival, const std::vector<SeenArrival> &seen,
    const ShockSettings &settings)
{
    VelocityEstimate estimate;
    estimate.velocity_m_s = settings.velocity_m_s.of(shot);
    if (estimate.velocity_m_s)
        return estimate;
    if (!settings.counters.empty())
        return withFit({},
            fitCounters(settings.counters, attenuationOf(settings.attenuation),
                settings.attenuation_per_m));
    return recordedVelocity(set, shot, dutArrival, seen, settings);
}

VelocityEstimate recordedVelocity(const CaptureSet &set, Index shot,
    const std::optional<DutArrival> &dutArrival, const std::vector<SeenArrival> &seen,
    const ShockSettings &settings)
{
    VelocityEstimate estimate;
    auto found = sightings(set, shot, dutArrival, seen, settings);
    if (!found)
        return missing(std::move(found.error()));
    std::stable_sort(found->begin(), found->end(),
        [](const Sighting &a, const Sighting &b) { return a.distance_m > b.distance_m; });
    estimate.sightings = std::move(*found);
    const Sighting &farthest = estimate.sightings.front();
    const Sighting &nearest = estimate.sightings.back();
    estimate.arrival_s = farthest.time_s;
    estimate.distance_m = farthest.distance_m;
    if (estimate.sightings.size() < 2 || farthest.distance_m == nearest.distance_m) {
        estimate.missing = tooFewMessage(settings.dutPosition == kEndWall);
        return estimate;
    }
    if (farthest.time_s >= nearest.time_s) {
        estimate.problem = wrongOrder(farthest, nearest);
        estimate.correction
            = exchangeRoles(set.shots.at(static_cast<std::size_t>(shot - 1)), farthest, nearest);
        return estimate;
    }
    estimate.relativeDistanceUncertainty = relativeDistanceUncertainty(estimate.sightings);
    estimate.usesUncorrectedDut = dutArrival && nearest.isDut && !dutArrival->delayCorrected;
    return withFit(estimate,
        fitVelocity(
            estimate.sightings, attenuationOf(settings.attenuation), settings.attenuation_per_m));
}

} // namespace dyncal
