// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/finding_mends.h"

#include "ui/session/capture_edit.h"

#include <QCoreApplication>

#include <algorithm>

namespace dyncal {

namespace {

struct Mends
{
    Q_DECLARE_TR_FUNCTIONS(Mends)
};

constexpr Index kLongestGap = 5; ///< samples; longer ones hide what happened
constexpr std::size_t kMostChannels = 6; ///< as buttons; beyond, the list of roles is clearer
constexpr std::size_t kUnitArgument = 3; ///< of CAP-013: the unit that fits, or ""

const Shot *shotOf(const Finding &finding, const CaptureSet &set)
{
    const auto position = static_cast<std::size_t>(finding.shot - 1);
    return finding.shot > 0 && position < set.shots.size() ? &set.shots[position] : nullptr;
}

Mend excludeShot(Index shot)
{
    const QString step = Mends::tr("Exclude shot %1").arg(shot);
    return {step + QStringLiteral("..."), step,
        Mends::tr("Why is this shot not used? The certificate prints the reason."),
        [shot](ImportSettings &settings, const std::string &reason) {
            setShotExcluded(settings, shot, reason);
        }};
}

std::vector<Mend> chooseDut(const Shot &shot)
{
    std::vector<Mend> mends;
    for (const Channel &channel : shot.channels) {
        if (mends.size() == kMostChannels)
            break;
        const QString name = QString::fromStdString(channel.name);
        mends.push_back(
            {Mends::tr("\"%1\" is the DUT").arg(name), Mends::tr("Choose %1 as the DUT").arg(name),
                {}, [name = channel.name](ImportSettings &settings, const std::string &) {
                    settings.channels[name] = channelRoleName(ChannelRole::Dut);
                }});
    }
    return mends;
}

/// Names by role, for every shot that has both.
std::vector<Mend> swapChannels(const Shot &shot)
{
    const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
    const Channel *side = shot.channelWithRole(ChannelRole::DrivenSide);
    if (!dut || !side || dut->name == side->name)
        return {};
    return {{Mends::tr("Swap in all shots"), Mends::tr("Swap DUT and driven side"), {},
        [first = dut->name, second = side->name](ImportSettings &settings, const std::string &) {
            settings.channels[first] = channelRoleName(ChannelRole::DrivenSide);
            settings.channels[second] = channelRoleName(ChannelRole::Dut);
        }}};
}

std::vector<Mend> useUnit(const Finding &finding)
{
    const auto &words = finding.message.arguments;
    if (words.size() <= kUnitArgument || words[kUnitArgument].empty())
        return {};
    const std::string unit = words[kUnitArgument];
    return {{Mends::tr("The unit is %1").arg(QString::fromStdString(unit)),
        Mends::tr("Change the DUT's unit"), {},
        [unit](ImportSettings &settings, const std::string &) { settings.unit = unit; }}};
}

Mend invertPolarity()
{
    return {Mends::tr("Invert polarity"), Mends::tr("Change the DUT's polarity"), {},
        [](ImportSettings &settings, const std::string &) {
            settings.polarity = -settings.polarity;
        }};
}

Mend interpolate()
{
    return {Mends::tr("Interpolate gaps of up to %1 samples").arg(kLongestGap),
        Mends::tr("Interpolate invalid samples"), {},
        [](ImportSettings &settings, const std::string &) {
            settings.interpolateInvalid = kLongestGap;
        }};
}

} // namespace

std::vector<Mend> mendsOf(const Finding &finding, const CaptureSet &set)
{
    const Shot *shot = shotOf(finding, set);
    const bool canExclude
        = shot && std::ranges::count_if(set.shots, &Shot::included) > 1 && shot->included;
    std::vector<Mend> mends;
    if (finding.id == "CAP-002" && shot)
        mends = chooseDut(*shot);
    else if (finding.id == "CAP-006")
        mends = {interpolate()};
    else if (finding.id == "CAP-010" && shot)
        mends = swapChannels(*shot);
    else if (finding.id == "CAP-012")
        mends = {invertPolarity()};
    else if (finding.id == "CAP-013")
        mends = useUnit(finding);
    for (const char *id : {"CAP-006", "CAP-007", "CAP-008", "CAP-009", "CAP-011", "CAP-020"})
        if (finding.id == id && canExclude)
            mends.push_back(excludeShot(finding.shot));
    return mends;
}

} // namespace dyncal
