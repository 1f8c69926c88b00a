// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/import_choices.h"

#include "core/capture/check_settings.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

/// The reader of HDF5 takes only the datasets that are named, or guesses if none is; so once one is
/// named, all that are read now must be named.
void nameChannelsRead(ImportSettings &settings, const ImportView &view)
{
    for (const ImportChannel &channel : view.channels)
        settings.channels.emplace(channel.name, channelRoleName(channel.role));
}

/// Naming the columns of samples is how the recipe leaves a column of times out.
void nameSampleColumns(ImportSettings &settings, const ImportView &view)
{
    for (const ImportChannel &channel : view.channels)
        if (channel.column && channel.role != ChannelRole::Other)
            settings.columns.emplace(channelRoleName(channel.role), *channel.column);
    const auto first = std::ranges::find_if(
        view.channels, [](const ImportChannel &channel) { return channel.column.has_value(); });
    if (settings.columns.empty() && first != view.channels.end())
        settings.columns.emplace(channelRoleName(ChannelRole::Other), *first->column);
}

/// Where each column is a shot, another role leaves the column of times out. It is not known where
/// it contradicts the header; then it is the first.
void nameTimesOther(ImportSettings &settings, const ImportView &view)
{
    if (view.text->timeColumn || view.problem)
        settings.columns[channelRoleName(ChannelRole::Other)] = view.text->timeColumn.value_or(0);
}

} // namespace

bool leavesTimesOut(const ImportSettings &settings)
{
    return !settings.columns.empty() && !settings.columns.contains("time");
}

void chooseTimes(ImportSettings &settings, const ImportView &view, int choice)
{
    settings.columns.clear();
    if (choice == TimeNone && view.isShotPerColumn())
        nameTimesOther(settings, view);
    else if (choice == TimeNone)
        nameSampleColumns(settings, view);
    else if (choice >= TimeFirstColumn)
        settings.columns["time"] = choice - TimeFirstColumn;
}

void chooseShotColumns(ImportSettings &settings, const ImportView &view, bool each)
{
    settings.columnsAre = each ? kColumnsAreShots : kColumnsAreChannels;
    std::erase_if(settings.columns, [](const auto &entry) { return entry.first != "time"; });
    for (const ImportChannel &channel : view.channels) {
        settings.channels.erase(channel.name);
        settings.channelDetails.erase(channel.name);
    }
}

bool chooseRole(
    ImportSettings &settings, ImportView &view, const std::string &channel, ChannelRole role)
{
    if (!view.datasets.empty())
        nameChannelsRead(settings, view);
    if (role == ChannelRole::Dut)
        for (const ImportChannel &other : view.channels)
            if (other.role == ChannelRole::Dut && other.name != channel)
                settings.channels[other.name] = channelRoleName(ChannelRole::Other);
    settings.channels[channel] = channelRoleName(role);
    const bool again = leavesTimesOut(settings);
    if (again) {
        settings.columns.clear();
        applyRoles(view, settings);
        nameSampleColumns(settings, view);
    }
    applyRoles(view, settings);
    return again;
}

void chooseDatasetRole(ImportSettings &settings, const ImportView &view, const std::string &name,
    std::optional<ChannelRole> role)
{
    nameChannelsRead(settings, view);
    if (role == ChannelRole::Dut)
        for (auto &[other, otherRole] : settings.channels)
            if (channelRoleFromName(otherRole) == ChannelRole::Dut)
                otherRole = channelRoleName(ChannelRole::Other);
    if (role)
        settings.channels[name] = channelRoleName(*role);
    else
        settings.channels.erase(name);
}

bool needsRateReason(const ImportSettings &settings, const ImportView &view)
{
    const double tolerance = 0.01 * CheckSettings{}.rateMismatch_percent;
    return settings.sampleRate_Hz && view.sampleRate_Hz > 0.0
        && std::abs(*settings.sampleRate_Hz / view.sampleRate_Hz - 1.0) > tolerance;
}

} // namespace dyncal
