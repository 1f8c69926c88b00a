// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/sensor_card.h"

#include "core/base/number_text.h"
#include "core/capture/channel_units.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr double kUnstated_relative = 0.01; ///< standard uncertainty of a card that states none

std::string attribute(const Attributes &card, const char *name)
{
    const auto value = card.find(name);
    return value != card.end() ? value->second : std::string();
}

std::optional<double> nonZero(const Attributes &card, const char *name)
{
    const auto value = parseNumber(attribute(card, name));
    return value && std::isfinite(*value) && *value != 0.0 ? value : std::nullopt;
}

/// Who made it, what it is and its number; the id where no number is known.
std::string identityOf(const CaptureSet &set, const Channel &dut)
{
    const Attributes card = cardOf(set, dut);
    std::string serial = attribute(card, "serial");
    if (serial.empty())
        return dut.sensorId;
    std::string identity;
    for (const char *name : {"manufacturer", "model"})
        if (const std::string word = attribute(card, name); !word.empty())
            identity += word + " ";
    return identity + serial;
}

} // namespace

std::optional<CardSensitivity> sensitivityOfCard(const Attributes &card)
{
    const auto stated = nonZero(card, "sensitivity");
    const std::string unit = attribute(card, "sensitivity_unit");
    const auto stroke = unit.find('/');
    if (!stated || stroke == std::string::npos || stroke == 0)
        return std::nullopt;
    const std::string above = unit.substr(0, stroke);
    const auto below = siUnitOf(unit.substr(stroke + 1));
    if (!below || below->unit != "Pa")
        return std::nullopt;
    const SiUnit si = siUnitOf(above).value_or(SiUnit{above, 1.0});
    return CardSensitivity{
        *stated * si.factor / below->factor, si.unit + "/Pa", relativeUncertaintyOfCard(card)};
}

std::optional<double> relativeUncertaintyOfCard(const Attributes &card)
{
    const auto stated = nonZero(card, "sensitivity");
    const auto u = nonZero(card, "u_sensitivity");
    return stated && u ? std::optional(std::abs(*u / *stated)) : std::nullopt;
}

Attributes cardOf(const CaptureSet &set, const Channel &channel)
{
    const auto card = set.sensors.find(channel.sensorId);
    return card != set.sensors.end() ? card->second : Attributes();
}

std::optional<Finding> typedAgainstCard(
    const Attributes &card, const Channel &channel, double typed)
{
    const auto stated = sensitivityOfCard(card);
    if (!stated || stated->unit != channel.unit + "/Pa")
        return std::nullopt;
    const double relative = std::abs(typed / stated->value) - 1.0;
    const double limit = 2.0 * stated->u_relative.value_or(kUnstated_relative);
    if (std::abs(relative) <= limit)
        return std::nullopt;
    return Finding{.id = "CAP-032",
        .severity = Severity::Caution,
        .channel = channel.name,
        .message
        = {DYNCAL_TEXT("core",
               "Channel '%1': the recipe states a sensitivity of %2, the card of the sensor %3, which is %4 % different. The recipe's is used; correct it, or the card."),
            {channel.name, numberWithUnit(typed, stated->unit, 5),
                numberWithUnit(stated->value, stated->unit, 5),
                numberText(100.0 * std::abs(relative), 2)}},
        .value = relative,
        .limit = limit,
        .causes = {FindingCause::Typed, FindingCause::Scale}};
}

Findings checkOneSensor(const CaptureSet &set)
{
    std::string first;
    std::size_t firstShot = 0;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Shot &shot = set.shots[i];
        const Channel *dut = shot.included ? shot.channelWithRole(ChannelRole::Dut) : nullptr;
        const std::string identity = dut ? identityOf(set, *dut) : std::string();
        if (identity.empty() || identity == first)
            continue;
        if (first.empty()) {
            first = identity;
            firstShot = i + 1;
            continue;
        }
        return {{.id = "CAP-031",
            .severity = Severity::Caution,
            .shot = static_cast<Index>(i) + 1,
            .channel = dut->name,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1 is of the sensor %2, shot %3 of the sensor %4: a calibration is of one sensor. Take the shots of the other one out, or correct the captures."),
                {std::to_string(firstShot), first, std::to_string(i + 1), identity}}}};
    }
    return {};
}

} // namespace dyncal
