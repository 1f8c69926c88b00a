// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/channel_roles.h"

#include "ui/text/level_text.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <map>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct RoleText
{
    Q_DECLARE_TR_FUNCTIONS(ChannelRoles)
};

} // namespace

ChannelRole usualRole(const std::vector<Shot> &shots, const std::string &channel)
{
    std::map<ChannelRole, int> counts;
    std::vector<ChannelRole> seen;
    for (const Shot &shot : shots)
        for (const Channel &one : shot.channels)
            if (one.name == channel && counts[one.role]++ == 0)
                seen.push_back(one.role);
    const auto most = std::ranges::max_element(
        seen, {}, [&](ChannelRole role) { return counts[role]; }); // the first of the largest
    return most == seen.end() ? ChannelRole::Other : *most;
}

QString otherRoles(const std::vector<Shot> &shots)
{
    QStringList sentences;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        QStringList others;
        for (const Channel &channel : shots[i].channels)
            if (channel.role != usualRole(shots, channel.name))
                others << RoleText::tr("%1 is %2")
                              .arg(shownText(channel.name), roleText(channel.role));
        if (!others.isEmpty())
            sentences << RoleText::tr("In shot %1: %2.")
                             .arg(i + 1)
                             .arg(others.join(QStringLiteral(", ")));
    }
    return sentences.join(QLatin1Char(' '));
}

} // namespace dyncal
