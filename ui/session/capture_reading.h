// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"

#include <string>
#include <vector>

namespace dyncal {

/// A file, or folder, that could not be read.
struct FileProblem
{
    std::string path;
    Error error;
};

/// What several files gave: the shots of all that could be read, and what is wrong with each other.
struct CapturesRead
{
    CaptureSet set;
    std::vector<FileProblem> problems;
};

/// Reads every file (or folder, or the built-in example by kExamplePath) for itself, so that one
/// bad file does not stop the others. They are opened, not sealed: the session does that before
/// anything is computed. Fails only if cancelled.
Result<CapturesRead> readEach(const std::vector<std::string> &paths, const ImportSettings &settings,
    const JobControl &control);

/// Reads the files of `captures` once more under other settings. Shots that had been removed stay
/// away: numbers in a recipe keep their meaning.
Result<CapturesRead> readAgain(
    const CaptureSet &captures, const ImportSettings &settings, const JobControl &control);

/// The recordings of a job and more: files of one recording become one shot (channel_files.h),
/// which keeps its number.
CaptureSet addedCaptures(
    const CaptureSet &job, const CaptureSet &more, const ImportSettings &settings);

/// Whether a reader takes only the channels that the recipe names, once it names one: whoever gives
/// one of them a role must name the others, too.
bool readsOnlyNamedChannels(const InputFile &input);

/// Whether files must be read again when the import section changes from one to the other; the
/// rest of the section is applied to what was read.
bool needsReading(
    const CaptureSet &captures, const ImportSettings &before, const ImportSettings &after);

} // namespace dyncal
