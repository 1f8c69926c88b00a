// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/shot_columns.h"

#include "core/capture/channel.h"

namespace dyncal {

bool areColumnsShots(const ImportSettings &settings)
{
    return settings.columnsAre == kColumnsAreShots;
}

std::vector<Index> shotsOfColumns(
    const ImportSettings &settings, Index columns, std::optional<Index> timeColumn)
{
    std::vector<bool> isShot(static_cast<std::size_t>(columns), true);
    for (const auto &[role, column] : settings.columns)
        if (column >= 0 && column < columns)
            isShot[static_cast<std::size_t>(column)] = false;
    if (timeColumn && *timeColumn >= 0 && *timeColumn < columns)
        isShot[static_cast<std::size_t>(*timeColumn)] = false;
    std::vector<Index> shots;
    shots.reserve(isShot.size());
    Index number = 0;
    for (const bool shot : isShot)
        shots.push_back(shot ? ++number : 0);
    return shots;
}

Result<void> checkShotColumns(const std::string &path, const ImportSettings &settings)
{
    if (!areColumnsShots(settings) || !settings.columns.contains(channelRoleName(ChannelRole::Dut)))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1: by import.columns_are each column is a shot of the DUT, so import.columns.dut cannot name one of them; leave it out."),
            {path}});
}

} // namespace dyncal
