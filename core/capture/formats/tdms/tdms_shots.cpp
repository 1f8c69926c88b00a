// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_shots.h"

#include <algorithm>
#include <map>
#include <set>

namespace dyncal {
namespace {

/// A group with its channels that have samples, in the order of the file.
struct Group
{
    std::string name;
    const TdmsObject *object = nullptr; ///< null if the file does not describe it
    std::vector<const TdmsObject *> channels;
};

std::vector<Group> groupsOf(const TdmsContents &contents)
{
    std::vector<Group> groups;
    std::map<std::string, std::size_t> known;
    for (const TdmsObject &object : contents.objects) {
        if (object.path.level == TdmsLevel::File)
            continue;
        const auto [place, isNew] = known.try_emplace(object.path.group, groups.size());
        if (isNew)
            groups.push_back({object.path.group, nullptr, {}});
        Group &group = groups[place->second];
        if (object.path.level == TdmsLevel::Group)
            group.object = &object;
        else
            group.channels.push_back(&object);
    }
    std::erase_if(groups, [](const Group &group) { return group.channels.empty(); });
    return groups;
}

/// SignalExpress writes these to the group and again to its channels.
std::optional<std::uint64_t> countIn(const Group &group, const char *name)
{
    const auto count
        = group.object != nullptr ? countOf(group.object->properties, name) : std::nullopt;
    return count ? count : countOf(group.channels.front()->properties, name);
}

Finding leftOut(Message message)
{
    return {.id = "CAP-026", .severity = Severity::Info, .message = std::move(message)};
}

bool isSignalExpress(const std::vector<Group> &groups)
{
    return std::any_of(groups.begin(), groups.end(),
        [](const Group &group) { return countIn(group, "DecimationLevel").has_value(); });
}

void findUnfinishedLog(const TdmsContents &contents, const std::string &path, TdmsShots &shots)
{
    const TdmsObject *root = contents.root();
    const auto complete
        = root != nullptr ? countOf(root->properties, "recording-complete") : std::nullopt;
    if (complete.value_or(1) != 0)
        return;
    shots.findings.push_back({.id = "CAP-018",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1 says that its recording was not completed; check that the records are whole."),
            {path}}});
}

TdmsShots signalExpressShots(
    const TdmsContents &contents, std::vector<Group> groups, const std::string &path)
{
    TdmsShots shots;
    const auto thinned = std::erase_if(groups,
        [](const Group &group) { return countIn(group, "DecimationLevel").value_or(0) > 0; });
    if (thinned > 0)
        shots.findings.push_back(
            leftOut({DYNCAL_TEXT("core",
                         "%1: %2 groups with thinned-out copies of the records were left out."),
                {path, std::to_string(thinned)}}));
    std::map<std::uint64_t, TdmsShotPlan> intervals;
    for (const Group &group : groups) {
        const std::uint64_t index = countIn(group, "IntervalIndex").value_or(0);
        TdmsShotPlan &plan = intervals[index];
        plan.name = "interval " + std::to_string(index + 1);
        plan.channels.insert(plan.channels.end(), group.channels.begin(), group.channels.end());
    }
    for (auto &[index, plan] : intervals)
        shots.shots.push_back(std::move(plan));
    if (shots.shots.size() > 1)
        shots.findings.push_back({.id = "CAP-028",
            .severity = Severity::Info,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: each of its %2 logged intervals was taken as a shot; exclude those that are none."),
                {path, std::to_string(shots.shots.size())}}});
    findUnfinishedLog(contents, path, shots);
    return shots;
}

std::set<std::string> namesOf(const Group &group)
{
    std::set<std::string> names;
    for (const TdmsObject *channel : group.channels)
        names.insert(channel->path.channel);
    return names;
}

/// The channel names that most groups have, if at least two groups have the same.
std::set<std::string> commonNames(const std::vector<Group> &groups)
{
    std::map<std::set<std::string>, int> counts;
    for (const Group &group : groups)
        ++counts[namesOf(group)];
    const auto most = std::max_element(counts.begin(), counts.end(),
        [](const auto &a, const auto &b) { return a.second < b.second; });
    return most != counts.end() && most->second > 1 ? most->first : std::set<std::string>();
}

TdmsShots plainShots(const std::vector<Group> &groups, const std::string &path)
{
    TdmsShots shots;
    const std::set<std::string> common = commonNames(groups);
    if (common.empty()) {
        TdmsShotPlan &plan = shots.shots.emplace_back();
        for (const Group &group : groups)
            plan.channels.insert(plan.channels.end(), group.channels.begin(), group.channels.end());
        return shots;
    }
    for (const Group &group : groups) {
        if (namesOf(group) == common)
            shots.shots.push_back({group.name, group.channels});
        else
            shots.findings.push_back(leftOut(
                {DYNCAL_TEXT("core",
                     "%1: the group \"%2\" was left out because its channels are not those of the other groups, of which each is a shot."),
                    {path, group.name}}));
    }
    return shots;
}

} // namespace

TdmsShots tdmsShots(const TdmsContents &contents, const std::string &path)
{
    std::vector<Group> groups = groupsOf(contents);
    TdmsShots shots = isSignalExpress(groups)
        ? signalExpressShots(contents, std::move(groups), path)
        : plainShots(groups, path);
    if (shots.shots.size() == 1)
        shots.shots.front().name.clear();
    return shots;
}

} // namespace dyncal
