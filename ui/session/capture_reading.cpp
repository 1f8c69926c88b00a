// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/capture_reading.h"

#include "core/capture/joined_captures.h"
#include "core/capture/opening/capture_open.h"
#include "core/capture/opening/channel_files.h"
#include "ui/session/capture_edit.h"
#include "ui/session/example.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace dyncal {

namespace {

Result<CaptureSet> readOne(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    return path == kExamplePath ? exampleCaptures(control)
                                : openCaptures({path}, settings, control);
}

using ShotName = std::pair<std::string, Index>; ///< its file, and its place in it

/// One for every file that the shot's channels come from.
std::set<ShotName> namesOf(const CaptureSet &set, const Shot &shot)
{
    std::set<ShotName> names;
    const auto add = [&](Index input) {
        if (input >= 0 && input < std::ssize(set.inputs))
            names.emplace(set.inputs[static_cast<std::size_t>(input)].path, shot.inFile);
    };
    add(shot.input);
    for (const Channel &channel : shot.channels)
        add(channel.input.value_or(shot.input));
    return names;
}

std::set<std::string> namesOf(const std::map<std::string, std::string> &roles)
{
    std::set<std::string> names;
    for (const auto &[name, role] : roles)
        names.insert(name);
    return names;
}

} // namespace

Result<CapturesRead> readEach(const std::vector<std::string> &paths, const ImportSettings &settings,
    const JobControl &control)
{
    CapturesRead read;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Result<CaptureSet> part = readOne(paths[i], settings, control.part(i, paths.size()));
        if (part)
            read.set = joinedCaptures(std::move(read.set), *part);
        else if (part.error().kind == ErrorKind::Cancelled)
            return tl::unexpected(part.error());
        else
            read.problems.push_back({paths[i], part.error()});
    }
    read.set = addedCaptures({}, read.set, settings);
    return read;
}

Result<CapturesRead> readAgain(
    const CaptureSet &captures, const ImportSettings &settings, const JobControl &control)
{
    std::vector<std::string> paths;
    for (const InputFile &input : captures.inputs)
        paths.push_back(input.path);
    Result<CapturesRead> read = readEach(paths, settings, control);
    if (!read)
        return read;
    std::map<std::string, const InputFile *> known;
    for (const InputFile &input : captures.inputs)
        known.try_emplace(input.path, &input);
    for (InputFile &input : read->set.inputs) {
        const auto same = known.find(input.path);
        if (same != known.end())
            input.expectedSha256 = same->second->expectedSha256;
    }
    std::ranges::copy_if(captures.findings, std::back_inserter(read->set.findings),
        [](const Finding &finding) { return finding.id.starts_with("PRJ-"); });
    std::set<ShotName> before;
    for (const Shot &shot : captures.shots)
        before.merge(namesOf(captures, shot));
    const auto wasThere = [&](const ShotName &name) { return before.contains(name); };
    read->set = withoutShots(read->set,
        [&](const Shot &shot) { return std::ranges::none_of(namesOf(read->set, shot), wasThere); });
    return read;
}

CaptureSet addedCaptures(
    const CaptureSet &job, const CaptureSet &more, const ImportSettings &settings)
{
    CaptureSet all = joinedCaptures(job, more);
    if (settings.channelFiles == kJoinChannelFiles)
        joinChannelFiles(all);
    return all;
}

bool readsOnlyNamedChannels(const InputFile &input)
{
    return input.format == "hdf5" || input.format == "mat73";
}

bool needsReading(
    const CaptureSet &captures, const ImportSettings &before, const ImportSettings &after)
{
    if (before.channelFiles != after.channelFiles)
        return captures.inputs.size() > 1;
    return std::ranges::any_of(captures.inputs, [&](const InputFile &input) {
        const ImportSettings a = settingsOfFile(before, input.path);
        const ImportSettings b = settingsOfFile(after, input.path);
        // A reader of tables compares the stated rate with the times in the file.
        return input.path != kExamplePath
            && (a.format != b.format || a.columns != b.columns || a.decimal != b.decimal
                || a.separator != b.separator || a.skipRows != b.skipRows
                || a.sampleRate_Hz != b.sampleRate_Hz
                || (readsOnlyNamedChannels(input) && namesOf(a.channels) != namesOf(b.channels)));
    });
}

} // namespace dyncal
