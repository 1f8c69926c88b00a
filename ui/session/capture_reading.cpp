// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/capture_reading.h"

#include "core/capture/format_registry.h"
#include "ui/session/capture_edit.h"
#include "ui/session/example.h"

#include <algorithm>
#include <set>

namespace dyncal {

namespace {

Result<CaptureSet> readOne(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    return path == kExamplePath ? exampleCaptures(control)
                                : openCaptures({path}, settings, control);
}

using ShotName = std::pair<std::string, Index>; ///< of its file, its place there

ShotName nameOf(const CaptureSet &set, const Shot &shot)
{
    const auto input = static_cast<std::size_t>(shot.input);
    return {input < set.inputs.size() ? set.inputs[input].path : std::string(), shot.inFile};
}

} // namespace

Result<CapturesRead> readEach(const std::vector<std::string> &paths, const ImportSettings &settings,
    const JobControl &control)
{
    CapturesRead read;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Result<CaptureSet> part = readOne(paths[i], settings, control.part(i, paths.size()));
        if (part)
            read.set = joinedCaptures(read.set, *part);
        else if (part.error().kind == ErrorKind::Cancelled)
            return tl::unexpected(part.error());
        else
            read.problems.push_back({paths[i], part.error()});
    }
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
    std::set<ShotName> before;
    for (const Shot &shot : captures.shots)
        before.insert(nameOf(captures, shot));
    const CaptureSet all = read->set;
    for (std::size_t i = all.shots.size(); i > 0; --i)
        if (!before.contains(nameOf(all, all.shots[i - 1])))
            read->set = withoutShot(read->set, static_cast<Index>(i));
    return read;
}

bool needsReading(
    const CaptureSet &captures, const ImportSettings &before, const ImportSettings &after)
{
    return std::ranges::any_of(captures.inputs, [&](const InputFile &input) {
        const ImportSettings a = settingsOfFile(before, input.path);
        const ImportSettings b = settingsOfFile(after, input.path);
        // A reader of tables holds the stated rate against the times of the file.
        return input.path != kExamplePath
            && (a.format != b.format || a.columns != b.columns || a.decimal != b.decimal
                || a.separator != b.separator || a.skipRows != b.skipRows
                || a.sampleRate_Hz != b.sampleRate_Hz);
    });
}

} // namespace dyncal
