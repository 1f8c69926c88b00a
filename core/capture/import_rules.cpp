// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/import_rules.h"

#include "core/base/number_text.h"
#include "core/capture/channel_rules.h"
#include "core/capture/sensor_card.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace dyncal {
namespace {

std::string quotedList(const std::set<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text.append(text.empty() ? "'" : ", '").append(word).append("'");
    return text;
}

/// The settings of every input.
std::vector<ImportSettings> settingsOfInputs(const CaptureSet &set, const ImportSettings &settings)
{
    std::vector<ImportSettings> own;
    for (const InputFile &input : set.inputs)
        own.push_back(settingsOfFile(settings, input.file));
    return own;
}

/// Every name that a setting may hold for a channel.
std::set<std::string> namedChannels(const std::map<std::string, std::string> &roles,
    const std::map<std::string, ChannelImport> &details)
{
    std::set<std::string> names;
    for (const auto &[name, role] : roles)
        names.insert(name);
    for (const auto &[name, detail] : details)
        names.insert(name);
    return names;
}

/// Channels of all shots, or of those of one file.
std::set<std::string> channelsOf(const CaptureSet &set, const std::string &file = {})
{
    std::set<std::string> names;
    for (const Shot &shot : set.shots) {
        for (const Channel &channel : shot.channels) {
            const auto input = static_cast<std::size_t>(inputOf(shot, channel));
            if (file.empty() || (input < set.inputs.size() && set.inputs[input].file == file))
                names.insert(channel.name);
        }
    }
    return names;
}

Result<void> checkChannels(const std::string &key, const std::set<std::string> &named,
    const std::set<std::string> &existing)
{
    for (const std::string &name : named) {
        if (!existing.contains(name))
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "Recipe %1 names a channel '%2' that no shot has; the channels are %3."),
                    {key, name, quotedList(existing)}});
    }
    return {};
}

/// Whether every shot with roles of its own exists once, and has the channels.
Result<void> checkShots(const CaptureSet &set, const std::vector<ShotImport> &list)
{
    std::set<Index> seen;
    for (const ShotImport &own : list) {
        const std::string number = std::to_string(own.shot);
        if (own.shot < 1 || own.shot > std::ssize(set.shots))
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT(
                            "core", "Recipe import.shots names shot %1; the shots are 1 to %2."),
                    {number, std::to_string(set.shots.size())}});
        if (!seen.insert(own.shot).second)
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT("core", "Recipe import.shots names shot %1 twice."), {number}});
        std::set<std::string> existing;
        for (const Channel &channel : set.shots[static_cast<std::size_t>(own.shot - 1)].channels)
            existing.insert(channel.name);
        if (const auto known = checkChannels(
                "import.shots[" + number + "].channels", namedChannels(own.channels, {}), existing);
            !known)
            return known;
    }
    return {};
}

/// Whether everything that the settings name exists.
Result<void> checkNames(const CaptureSet &set, const ImportSettings &settings)
{
    if (const auto known = checkChannels("import.channels",
            namedChannels(settings.channels, settings.channelDetails), channelsOf(set));
        !known)
        return known;
    std::set<std::string> files;
    for (const InputFile &input : set.inputs)
        files.insert(input.file);
    for (const auto &[file, own] : settings.files) {
        if (!files.contains(file))
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "Recipe import.files names '%1', which is none of the inputs; these are %2."),
                    {file, quotedList(files)}});
        if (const auto known = checkChannels("import.files." + file + ".channels",
                namedChannels(own.channels, own.channelDetails), channelsOf(set, file));
            !known)
            return known;
    }
    return checkShots(set, settings.shots);
}

/// The settings for each channel's file.
using OwnSettings = std::function<const ImportSettings &(const Channel &)>;

/// `ofShot`: the roles for this shot alone, or null.
void assignRoles(
    Shot &shot, const OwnSettings &own, const std::map<std::string, std::string> *ofShot)
{
    const auto roleOf = [&](const Channel &channel) -> const std::string * {
        if (ofShot && ofShot->contains(channel.name))
            return &ofShot->at(channel.name);
        const std::map<std::string, std::string> &roles = own(channel).channels;
        const auto role = roles.find(channel.name);
        return role != roles.end() ? &role->second : nullptr;
    };
    const bool namesDutHere
        = std::any_of(shot.channels.begin(), shot.channels.end(), [&](const Channel &channel) {
              const std::string *role = roleOf(channel);
              return role != nullptr && *role == "dut";
          });
    const bool hasOwnDut = ofShot
        && std::ranges::any_of(*ofShot, [](const auto &entry) { return entry.second == "dut"; });
    for (Channel &channel : shot.channels) {
        if (const std::string *role = roleOf(channel))
            channel.role = channelRoleFromName(*role);
        else if (namesDutHere && channel.role == ChannelRole::Dut)
            channel.role = ChannelRole::Other; // the recipe's DUT replaces the file's
        if (hasOwnDut && channel.role == ChannelRole::Dut && !ofShot->contains(channel.name))
            channel.role = ChannelRole::Other; // and the shot's that of all
    }
    if (shot.channelWithRole(ChannelRole::Dut) == nullptr && shot.channels.size() == 1)
        shot.channels.front().role = ChannelRole::Dut;
}

/// Why the reader knows no rate for the channel, if it said so: files that contradict themselves do
/// state one.
const Finding *reasonOfReader(
    const CaptureSet &set, Index number, const Shot &shot, const Channel &channel)
{
    const auto input = static_cast<std::size_t>(inputOf(shot, channel));
    const auto found = std::ranges::find_if(set.findings, [&](const Finding &finding) {
        const std::vector<std::string> &words = finding.message.arguments;
        return (finding.id == "CAP-003" || finding.id == "CAP-016")
            && finding.severity == Severity::Caution
            && (finding.shot == 0 || finding.shot == number)
            && (finding.channel.empty() || finding.channel == channel.name
                || finding.channel.ends_with("/" + channel.name))
            && input < set.inputs.size() && !words.empty()
            && words.front() == set.inputs[input].path;
    });
    return found != set.findings.end() ? &*found : nullptr;
}

/// setSampleRate, with the reader's own words where there is no rate.
Result<void> rate(CaptureSet &set, Index number, const Shot &shot, Channel &channel,
    const ImportSettings &settings, const CheckSettings &checks)
{
    const bool isUnknown = !(channel.sampleRate_Hz > 0.0) && !settings.sampleRate_Hz;
    if (const Finding *reason = isUnknown ? reasonOfReader(set, number, shot, channel) : nullptr)
        return fail(ErrorKind::DataBlocked, reason->message, "CAP-003", number);
    return setSampleRate(channel, number, settings, checks, set.findings);
}

Result<void> applyToShots(
    CaptureSet &set, const ImportSettings &settings, const CheckSettings &checks)
{
    const std::vector<ImportSettings> ofInputs = settingsOfInputs(set, settings);
    Index number = 0;
    for (Shot &shot : set.shots) {
        ++number;
        const auto own = [&](const Channel &channel) -> const ImportSettings & {
            const auto input = static_cast<std::size_t>(inputOf(shot, channel));
            return input < ofInputs.size() ? ofInputs[input] : settings;
        };
        assignRoles(shot, own, rolesOfShot(settings, number));
        for (Channel &channel : shot.channels) {
            const auto done = rate(set, number, shot, channel, own(channel), checks).and_then([&] {
                return shapeChannel(
                    channel, number, own(channel), cardOf(set, channel), set.findings);
            });
            if (!done)
                return done;
        }
    }
    return {};
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

Result<CaptureSet> applyImportSettings(
    CaptureSet set, const ImportSettings &settings, const CheckSettings &checks)
{
    // checkCaptures() reports equal data again, among the included shots only.
    std::erase_if(set.findings, [](const Finding &finding) { return finding.id == "CAP-011"; });
    const auto done = checkNames(set, settings)
                          .and_then([&] { return applyToShots(set, settings, checks); })
                          .and_then([&] { return setLevels(set, settings.levels); })
                          .and_then([&] { return excludeShots(set, settings.exclude); });
    if (!done)
        return tl::unexpected(done.error());
    return set;
}

} // namespace dyncal
