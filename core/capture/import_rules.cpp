// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/import_rules.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace dyncal {
namespace {

/// All channel names of the set, quoted, for messages.
std::string channelNames(const CaptureSet &set)
{
    std::set<std::string> names;
    for (const Shot &shot : set.shots) {
        for (const Channel &channel : shot.channels)
            names.insert(channel.name);
    }
    std::string text;
    for (const std::string &name : names)
        text.append(text.empty() ? "'" : ", '").append(name).append("'");
    return text;
}

Result<void> assignRoles(CaptureSet &set, const std::map<std::string, std::string> &roles)
{
    const bool givesDut = std::any_of(
        roles.begin(), roles.end(), [](const auto &entry) { return entry.second == "dut"; });
    for (Shot &shot : set.shots) {
        const bool namesDutHere = givesDut
            && std::any_of(shot.channels.begin(), shot.channels.end(), [&](const Channel &c) {
                   const auto role = roles.find(c.name);
                   return role != roles.end() && role->second == "dut";
               });
        for (Channel &channel : shot.channels) {
            const auto role = roles.find(channel.name);
            if (role != roles.end())
                channel.role = channelRoleFromName(role->second);
            else if (namesDutHere && channel.role == ChannelRole::Dut)
                channel.role = ChannelRole::Other; // the recipe's DUT replaces the file's
        }
        const bool hasDut = shot.channelWithRole(ChannelRole::Dut) != nullptr;
        if (!hasDut && shot.channels.size() == 1)
            shot.channels.front().role = ChannelRole::Dut;
    }
    for (const auto &entry : roles) {
        const std::string &name = entry.first; // clang 14 captures no parts of a pair
        const bool exists = std::any_of(set.shots.begin(), set.shots.end(), [&](const Shot &shot) {
            return std::any_of(shot.channels.begin(), shot.channels.end(),
                [&](const Channel &channel) { return channel.name == name; });
        });
        if (!exists) {
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT("core",
                            "Recipe import.channels names a channel '%1' that no shot has; the "
                            "channels are %2."),
                    {name, channelNames(set)}});
        }
    }
    return {};
}

Result<void> setRates(CaptureSet &set, const std::optional<double> &rate_Hz)
{
    bool overrides = false;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        for (Channel &channel : set.shots[i].channels) {
            if (rate_Hz) {
                overrides = overrides
                    || (channel.sampleRate_Hz > 0.0
                        && std::abs(channel.sampleRate_Hz - *rate_Hz) > 1e-9 * *rate_Hz);
                channel.sampleRate_Hz = *rate_Hz;
            }
            if (!(channel.sampleRate_Hz > 0.0) || !std::isfinite(channel.sampleRate_Hz)) {
                return fail(ErrorKind::DataBlocked,
                    Message{
                        DYNCAL_TEXT("core",
                            "Shot %1, channel '%2': the file states no sample rate and has no time "
                            "column; give import.sample_rate_hz in the recipe."),
                        {std::to_string(i + 1), channel.name}},
                    "CAP-003", static_cast<Index>(i) + 1);
            }
        }
    }
    if (overrides) {
        set.findings.push_back({"CAP-025", Severity::Info, 0, {}, {},
            {DYNCAL_TEXT("core", "The recipe's sample rate of %1 replaces what the files state."),
                {numberWithUnit(*rate_Hz, "Hz", 6)}},
            *rate_Hz, {}});
    }
    return {};
}

PressureReference referenceFromName(const std::string &name)
{
    if (name == "gauge")
        return PressureReference::Gauge;
    return name == "absolute" ? PressureReference::Absolute : PressureReference::Unknown;
}

/// Fills gaps of at most `longest` invalid samples on a straight line between their neighbours.
Index interpolateGaps(Channel &channel, Index longest)
{
    if (channel.samples.isInteger())
        return 0; // counts are always valid
    const Index size = channel.samples.size();
    std::vector<double> values(static_cast<std::size_t>(size));
    for (Index i = 0; i < size; ++i)
        values[static_cast<std::size_t>(i)] = channel.samples.at(i);
    Index filled = 0;
    for (Index i = 0; i < size;) {
        const auto at = [&](Index k) -> double & { return values[static_cast<std::size_t>(k)]; };
        if (std::isfinite(at(i))) {
            ++i;
            continue;
        }
        Index end = i;
        while (end < size && !std::isfinite(at(end)))
            ++end;
        if (i > 0 && end < size && end - i <= longest) {
            const double slope = (at(end) - at(i - 1)) / static_cast<double>(end - i + 1);
            const double from = at(i - 1);
            for (Index k = i; k < end; ++k)
                at(k) = from + slope * static_cast<double>(k - i + 1);
            filled += end - i;
        }
        i = end;
    }
    if (filled > 0)
        channel.samples = RawSamples(std::move(values)); // sha256 stays that of the recording
    return filled;
}

void shapeDut(CaptureSet &set, const ImportSettings &settings)
{
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        for (Channel &channel : set.shots[i].channels) {
            if (channel.role != ChannelRole::Dut)
                continue;
            if (settings.unit)
                channel.unit = *settings.unit;
            channel.userScale *= settings.scale;
            channel.polarity *= settings.polarity;
            if (!settings.reference.empty())
                channel.reference = referenceFromName(settings.reference);
            const Index filled = settings.interpolateInvalid > 0
                ? interpolateGaps(channel, settings.interpolateInvalid)
                : 0;
            if (filled > 0) {
                set.findings.push_back({"CAP-022", Severity::Caution, static_cast<Index>(i) + 1,
                    channel.name, {},
                    {DYNCAL_TEXT("core", "Shot %1, %2: %3 invalid samples were interpolated."),
                        {std::to_string(i + 1), channel.name, std::to_string(filled)}},
                    static_cast<double>(filled), static_cast<double>(settings.interpolateInvalid)});
            }
        }
    }
}

Result<void> setLevels(CaptureSet &set, const std::vector<std::string> &levels)
{
    if (levels.empty())
        return {};
    if (levels.size() != set.shots.size()) {
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Recipe import.levels has %1 entries for %2 shots; give one for each shot."),
                {std::to_string(levels.size()), std::to_string(set.shots.size())}});
    }
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (!levels[i].empty())
            set.shots[i].level = shotLevelFromName(levels[i]);
    }
    return {};
}

Result<void> excludeShots(CaptureSet &set, const std::vector<ExcludedShot> &list)
{
    for (const ExcludedShot &entry : list) {
        if (entry.shot < 1 || entry.shot > static_cast<Index>(set.shots.size())) {
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT(
                            "core", "Recipe import.exclude names shot %1; the shots are 1 to %2."),
                    {std::to_string(entry.shot), std::to_string(set.shots.size())}});
        }
        Shot &shot = set.shots[static_cast<std::size_t>(entry.shot - 1)];
        shot.included = false;
        shot.excludeReason = entry.reason;
    }
    const bool anyLeft = std::any_of(
        set.shots.begin(), set.shots.end(), [](const Shot &shot) { return shot.included; });
    if (!anyLeft) {
        return fail(ErrorKind::DataBlocked,
            Message{DYNCAL_TEXT(
                        "core", "All %1 shots are excluded; include at least one to calibrate."),
                {std::to_string(set.shots.size())}});
    }
    return {};
}

} // namespace

Result<CaptureSet> applyImportSettings(CaptureSet set, const ImportSettings &settings)
{
    const auto done = assignRoles(set, settings.channels)
                          .and_then([&] { return setRates(set, settings.sampleRate_Hz); })
                          .and_then([&] { return setLevels(set, settings.levels); })
                          .and_then([&] { return excludeShots(set, settings.exclude); });
    if (!done)
        return tl::unexpected(done.error());
    shapeDut(set, settings);
    return set;
}

} // namespace dyncal
