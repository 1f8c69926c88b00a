// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/import_view.h"

#include "core/base/number_text.h"
#include "core/capture/joined_captures.h"
#include "core/capture/opening/capture_open.h"
#include "core/capture/opening/channel_files.h"
#include "core/capture/opening/format_registry.h"
#include "ui/session/example.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace dyncal {

namespace {

constexpr const char *kTextFormat = "text";
constexpr std::size_t kHeadBytes = std::size_t{64} * 1024;

std::string recognisedFormat(const std::string &path, const ImportSettings &settings)
{
    if (settings.format != "auto")
        return settings.format;
    std::ifstream file(path, std::ios::binary);
    std::string head(kHeadBytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    int best = 0;
    std::string id;
    for (const CaptureFormat &format : captureFormats()) {
        const int score = format.recognise(path, head);
        if (score > best) {
            best = score;
            id = format.id;
        }
    }
    return id;
}

ChannelRole roleOf(const ImportChannel &channel, const ImportSettings &settings)
{
    if (channel.shot > 0)
        return ChannelRole::Dut;
    for (const auto &[role, column] : settings.columns)
        if (channel.column == column)
            return channelRoleFromName(role);
    const auto named = settings.channels.find(channel.name);
    return named == settings.channels.end() ? channel.fileRole : channelRoleFromName(named->second);
}

/// As applyImportSettings(): a DUT that is given replaces the file's; a single channel is the DUT.
void giveRoles(std::vector<ImportChannel> &channels, const ImportSettings &settings)
{
    const auto dutGiven = [&](const ImportChannel &channel) {
        const auto named = settings.channels.find(channel.name);
        return named != settings.channels.end()
            && channelRoleFromName(named->second) == ChannelRole::Dut;
    };
    const bool replaced = std::ranges::any_of(channels, dutGiven);
    for (ImportChannel &channel : channels) {
        channel.role = roleOf(channel, settings);
        if (replaced && channel.role == ChannelRole::Dut && !dutGiven(channel))
            channel.role = ChannelRole::Other;
    }
    if (channels.size() == 1)
        channels.front().role = ChannelRole::Dut;
}

ImportChannel textChannel(const TextPreview &text, std::size_t column)
{
    return {text.columnTitles[column], text.units[column], ChannelRole::Other, ChannelRole::Other,
        static_cast<Index>(column), 0,
        column < text.glances.size() ? text.glances[column] : ChannelGlance()};
}

void addTextChannels(ImportView &view)
{
    const TextPreview &text = *view.text;
    for (std::size_t i = 0; i < text.columnTitles.size(); ++i)
        if (text.timeColumn != static_cast<Index>(i))
            view.channels.push_back(textChannel(text, i));
}

/// One row per shot; what is said of one is said of the sensor.
void addShotColumns(ImportView &view)
{
    const TextPreview &text = *view.text;
    for (std::size_t i = 0; i < text.shots.size(); ++i) {
        if (text.shots[i] == 0)
            continue;
        ImportChannel channel = textChannel(text, i);
        channel.title = std::exchange(channel.name, kShotColumnChannel);
        channel.fileRole = channel.role = ChannelRole::Dut;
        channel.shot = text.shots[i];
        view.channels.push_back(std::move(channel));
    }
}

void addChannels(ImportView &view, const CaptureSet &set)
{
    for (const Shot &shot : set.shots) {
        for (const Channel &channel : shot.channels) {
            const auto known = std::ranges::find(view.channels, channel.name, &ImportChannel::name);
            if (known == view.channels.end())
                view.channels.push_back({channel.name, channel.unit, channel.role, channel.role, {},
                    channel.samples.size(), glanceAt(channel)});
            if (view.sampleRate_Hz <= 0.0)
                view.sampleRate_Hz = channel.sampleRate_Hz;
        }
    }
}

void proposeRoles(ImportView &view)
{
    std::vector<ChannelGlance> glances;
    glances.reserve(view.channels.size());
    for (const ImportChannel &channel : view.channels)
        glances.push_back(channel.glance);
    const std::vector<ChannelRole> roles = proposedRoles(glances);
    for (std::size_t i = 0; i < roles.size(); ++i)
        view.channels[i].proposed = roles[i];
}

/// "12.5 MHz" as the sentences of the core write it.
std::optional<double> hertzOf(const std::string &text)
{
    const std::size_t blank = text.find(' ');
    const std::optional<double> number = parseNumber(text.substr(0, blank));
    if (!number || blank == std::string::npos)
        return {};
    for (const auto &[unit, factor] :
        {std::pair{"Hz", 1.0}, std::pair{"kHz", 1e3}, std::pair{"MHz", 1e6}, std::pair{"GHz", 1e9}})
        if (text.substr(blank + 1) == unit)
            return *number * factor;
    return {};
}

/// The sentence on a header that contradicts the times ends with the two rates.
void noteContradiction(ImportView &view)
{
    constexpr std::size_t kArguments = 5;
    const std::vector<std::string> &words = view.problem->message.arguments;
    if (view.problem->findingId != "CAP-003" || words.size() != kArguments)
        return;
    view.headerRate_Hz = hertzOf(words[kArguments - 2]);
    view.timesRate_Hz = hertzOf(words[kArguments - 1]);
}

void lookAtText(ImportView &view, const std::string &path, const ImportSettings &settings)
{
    const Result<TextPreview> text = previewText(path, settings);
    if (!text) {
        view.problem = text.error();
        return;
    }
    view.text = *text;
    view.problem = text->problem;
    if (view.problem)
        noteContradiction(view);
    view.sampleRate_Hz = text->sampleRate_Hz;
    if (view.isShotPerColumn())
        addShotColumns(view);
    else
        addTextChannels(view);
}

/// Opens also files beside it that hold other channels of the same recording: roles are given to
/// all.
Result<CaptureSet> openWithOtherChannels(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    Result<CaptureSet> own = openCapture(path, settings, control);
    if (!own || settings.channelFiles != kJoinChannelFiles)
        return own;
    for (const std::string &file : channelFilesBeside(path)) {
        const auto other = file == path ? own : openCapture(file, settings, control);
        if (file != path && other)
            own = joinedCaptures(*own, *other);
    }
    joinChannelFiles(*own);
    std::erase_if(own->shots, [](const Shot &shot) { return !comesFrom(shot, 0); });
    return own;
}

void lookAtCapture(ImportView &view, const Result<CaptureSet> &set)
{
    if (set)
        addChannels(view, *set);
    else
        view.problem = set.error();
}

/// Lists all that an HDF5 file holds; the reader itself takes the named datasets, or guesses.
void lookAtDatasets(ImportView &view, const std::string &path, const JobControl &control)
{
    if (view.format != "hdf5" && view.format != "mat73")
        return;
    if (Result<std::vector<DatasetEntry>> datasets = listDatasets(path, control))
        view.datasets = std::move(*datasets);
}

} // namespace

bool ImportView::hasProposal() const
{
    return std::ranges::find(channels, ChannelRole::Dut, &ImportChannel::role) == channels.end()
        && std::ranges::find(channels, ChannelRole::Dut, &ImportChannel::proposed)
        != channels.end();
}

bool ImportView::isComplete(const ImportSettings &settings) const
{
    const bool ambiguous = text
        && (text->unreadableCells > 0 || (text->decimalAmbiguous && settings.decimal == "auto"));
    const auto duts = std::ranges::count(channels, ChannelRole::Dut, &ImportChannel::role);
    const auto needed = isShotPerColumn() ? std::max<std::ptrdiff_t>(std::ssize(channels), 1) : 1;
    return !problem && !ambiguous && duts == needed
        && (sampleRate_Hz > 0.0 || settings.sampleRate_Hz.has_value());
}

ImportView lookAtFile(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    ImportView view;
    const bool isExample = path == kExamplePath;
    view.format = isExample ? std::string() : recognisedFormat(path, settings);
    if (view.format == kTextFormat)
        lookAtText(view, path, settings);
    else {
        lookAtCapture(view,
            isExample ? exampleCaptures(control) : openWithOtherChannels(path, settings, control));
        lookAtDatasets(view, path, control);
    }
    if (!view.isShotPerColumn()) // there the roles are known
        proposeRoles(view);
    applyRoles(view, settings);
    return view;
}

void applyRoles(ImportView &view, const ImportSettings &settings)
{
    giveRoles(view.channels, settings);
}

std::string fileWithQuestion(const CaptureSet &set, const ImportSettings &settings)
{
    for (const Finding &finding : set.findings)
        if (finding.id == "CAP-019" && !finding.message.arguments.empty())
            return finding.message.arguments.front();
    for (const Shot &shot : set.shots) {
        const auto input = static_cast<std::size_t>(shot.input);
        if (input >= set.inputs.size())
            continue;
        const ImportSettings own = settingsOfFile(settings, set.inputs[input].path);
        std::vector<ImportChannel> channels;
        bool rateKnown = true;
        for (const Channel &channel : shot.channels) {
            channels.push_back({channel.name, {}, channel.role, channel.role, {}, 0});
            rateKnown = rateKnown && (own.sampleRate_Hz || channel.sampleRate_Hz > 0.0);
        }
        giveRoles(channels, own);
        const bool hasDut
            = std::ranges::find(channels, ChannelRole::Dut, &ImportChannel::role) != channels.end();
        if (!rateKnown || !hasDut)
            return set.inputs[input].path;
    }
    return {};
}

bool isQuestion(const Error &error)
{
    return error.findingId == "CAP-003" || error.findingId == "CAP-019";
}

} // namespace dyncal
