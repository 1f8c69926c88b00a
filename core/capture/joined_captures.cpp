// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/joined_captures.h"

#include <iterator>
#include <utility>

namespace dyncal {
namespace {

/// The id under which this card stands in `cards`: its own, unless another card has that.
std::string idFor(
    const std::map<std::string, Attributes> &cards, const std::string &id, const Attributes &card)
{
    std::string unique = id;
    for (int copy = 2; cards.contains(unique) && cards.at(unique) != card; ++copy)
        unique = id + " (" + std::to_string(copy) + ")";
    return unique;
}

void addSensors(CaptureSet &all, CaptureSet &part)
{
    std::map<std::string, std::string> renamed;
    for (auto &[id, card] : part.sensors) {
        const std::string unique = idFor(all.sensors, id, card);
        renamed.emplace(id, unique);
        all.sensors.emplace(unique, std::move(card));
    }
    for (Shot &shot : part.shots)
        for (Channel &channel : shot.channels)
            if (const auto own = renamed.find(channel.sensorId); own != renamed.end())
                channel.sensorId = own->second;
}

template <typename T>
void moveBehind(std::vector<T> &all, std::vector<T> &part)
{
    all.insert(
        all.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
}

} // namespace

CaptureSet joinedCaptures(CaptureSet first, CaptureSet second)
{
    CaptureSet all = std::move(first);
    const auto inputs = std::ssize(all.inputs);
    const auto shots = std::ssize(all.shots);
    for (Shot &shot : second.shots)
        moveInputs(shot, [&](Index input) { return input + inputs; });
    for (Finding &finding : second.findings)
        finding.shot += finding.shot > 0 ? shots : 0;
    addSensors(all, second);
    moveBehind(all.inputs, second.inputs);
    moveBehind(all.shots, second.shots);
    moveBehind(all.findings, second.findings);
    if (all.tube.empty())
        all.tube = std::move(second.tube);
    all.instruments.merge(second.instruments); // keeps existing entries: the first file counts
    return all;
}

} // namespace dyncal
