// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/capture_edit.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace dyncal {

bool isRecordingOf(const CaptureSet &set, const std::string &path)
{
    return std::ranges::any_of(set.inputs, [&](const InputFile &input) {
        std::error_code none; // no such file, and so no recording
        return std::filesystem::equivalent(input.path, path, none);
    });
}

namespace {

/// Drops what belongs to shot `number` and lowers the later numbers by one.
template <typename T>
void removeNumbered(std::vector<T> &list, Index number)
{
    std::erase_if(list, [&](const T &entry) { return entry.shot == number; });
    for (T &entry : list)
        if (entry.shot > number)
            --entry.shot;
}

template <typename T>
void removePosition(std::vector<T> &list, std::size_t position)
{
    if (position < list.size())
        list.erase(list.begin() + static_cast<Index>(position));
}

/// A list that may have one entry for all shots, or one for each.
template <typename T>
void removeOfEach(std::vector<T> &list, std::size_t position)
{
    if (list.size() > 1)
        removePosition(list, position);
}

/// A frequency of the tube that was read in this shot goes with it, because it is known for the gas
/// of that shot alone; one of the sensor is that of every shot.
void removeShotOfModes(std::vector<NuisanceMode> &modes, Index number)
{
    std::erase_if(modes, [&](const NuisanceMode &mode) {
        return mode.shot == number && mode.isTube && mode.frequency_Hz.size() == 1;
    });
    for (NuisanceMode &mode : modes) {
        removeOfEach(mode.frequency_Hz, static_cast<std::size_t>(number - 1));
        if (mode.shot == number)
            mode.shot = 0;
        else if (mode.shot > number)
            --mode.shot;
    }
}

/// Drops recordings' files that no shot comes from any more.
void removeUnusedInputs(CaptureSet &set)
{
    std::vector<bool> used(set.inputs.size(), false);
    for (Shot &shot : set.shots)
        moveInputs(shot, [&](Index input) {
            if (input >= 0 && input < std::ssize(used))
                used[static_cast<std::size_t>(input)] = true;
            return input;
        });
    std::vector<Index> place;
    std::vector<InputFile> kept;
    for (std::size_t i = 0; i < used.size(); ++i) {
        place.push_back(std::ssize(kept));
        if (used[i])
            kept.push_back(std::move(set.inputs[i]));
    }
    set.inputs = std::move(kept);
    for (Shot &shot : set.shots)
        moveInputs(shot, [&](Index input) {
            return input >= 0 && input < std::ssize(place) ? place[static_cast<std::size_t>(input)]
                                                           : input;
        });
}

} // namespace

void forgetMissingNames(ImportSettings &settings, const CaptureSet &set)
{
    std::erase_if(settings.files, [&](const auto &entry) {
        return std::ranges::find(set.inputs, entry.first, &InputFile::file) == set.inputs.end();
    });
    const auto missing = [&](const auto &entry) {
        return std::ranges::none_of(set.shots, [&](const Shot &shot) {
            return std::ranges::find(shot.channels, entry.first, &Channel::name)
                != shot.channels.end();
        });
    };
    std::erase_if(settings.channels, missing);
    std::erase_if(settings.channelDetails, missing);
    std::erase_if(settings.shots,
        [&](const ShotImport &own) { return own.shot < 1 || own.shot > std::ssize(set.shots); });
    for (ShotImport &own : settings.shots)
        std::erase_if(own.channels, [&](const auto &entry) {
            const auto &channels = set.shots[static_cast<std::size_t>(own.shot - 1)].channels;
            return std::ranges::find(channels, entry.first, &Channel::name) == channels.end();
        });
    std::erase_if(settings.shots, [](const ShotImport &own) { return own.channels.empty(); });
}

CaptureSet withoutShots(CaptureSet set, const std::function<bool(const Shot &)> &isOut)
{
    std::vector<Shot> kept;
    std::vector<Index> numbers{0}; // new number by old number; 0: taken out
    for (Shot &shot : set.shots) {
        const bool out = isOut(shot);
        if (!out)
            kept.push_back(std::move(shot));
        numbers.push_back(out ? 0 : std::ssize(kept));
    }
    set.shots = std::move(kept);
    std::erase_if(set.findings, [&](Finding &finding) {
        if (finding.shot <= 0 || finding.shot >= std::ssize(numbers))
            return false;
        finding.shot = numbers[static_cast<std::size_t>(finding.shot)];
        return finding.shot == 0;
    });
    removeUnusedInputs(set);
    return set;
}

ProjectState withoutShot(const ProjectState &state, Index number)
{
    const auto position = static_cast<std::size_t>(number - 1);
    if (number < 1 || position >= state.captures->shots.size())
        return state;
    ProjectState next{std::make_shared<const CaptureSet>(withoutShots(*state.captures,
                          [&, at = Index(0)](const Shot &) mutable { return ++at == number; })),
        state.recipe};
    removeNumbered(next.recipe.import.shots, number); // before names are looked up by number
    forgetMissingNames(next.recipe.import, *next.captures);
    removePosition(next.recipe.import.levels, position);
    removeNumbered(next.recipe.import.exclude, number);
    removeNumbered(next.recipe.acknowledge, number);
    removeOfEach(next.recipe.window.start_s, position);
    removePosition(next.recipe.window.ownEnds_s, position);
    removeNumbered(next.recipe.window.excludeStretches, number);
    removeShotOfModes(next.recipe.realization.nuisanceModes, number);
    for (ArrivalSensor &sensor : next.recipe.shock.arrivalSensors)
        removePosition(sensor.shotArrival_s, position);
    return next;
}

void setShotExcluded(
    ImportSettings &settings, Index number, const std::optional<std::string> &reason)
{
    std::erase_if(
        settings.exclude, [&](const ExcludedShot &entry) { return entry.shot == number; });
    if (reason)
        settings.exclude.push_back({number, *reason});
    std::ranges::sort(settings.exclude, {}, &ExcludedShot::shot);
}

} // namespace dyncal
