// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/recording_search.h"

#include "core/base/content_hash.h"
#include "core/capture/natural_order.h"
#include "core/capture/opening/format_registry.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

bool isHidden(const fs::path &path)
{
    return path.filename().string().starts_with('.');
}

bool isNamed(const std::string &path, const std::string &name)
{
    return fs::path(path).filename() == name;
}

bool hasReader(const std::string &path)
{
    return formatOf(path, ImportSettings()).has_value();
}

/// Adds the regular files of the folder; with `isDeep` of all below it too.
void addFilesOf(const fs::path &folder, bool isDeep, std::vector<std::string> &files)
{
    const std::size_t first = files.size();
    std::error_code ignored; // what cannot be listed holds nothing that could be read
    for (fs::recursive_directory_iterator
             entry(folder, fs::directory_options::skip_permission_denied, ignored),
         end;
         entry != end; entry.increment(ignored)) {
        const bool isFolder = entry->is_directory(ignored);
        if (isFolder && (!isDeep || isHidden(entry->path())))
            entry.disable_recursion_pending();
        else if (!isHidden(entry->path()) && entry->is_regular_file(ignored))
            files.push_back(entry->path().string());
    }
    std::ranges::sort(files.begin() + static_cast<std::ptrdiff_t>(first), files.end(), naturalLess);
}

/// The folder that a run's folder lies in.
fs::path besideOf(const std::string &folder)
{
    std::error_code ignored;
    return fs::weakly_canonical(folder, ignored).parent_path();
}

} // namespace

Result<RecordingSearch> RecordingSearch::in(const std::vector<std::string> &folders)
{
    RecordingSearch search;
    for (const std::string &folder : folders) {
        std::error_code unknown;
        if (!fs::is_directory(folder, unknown))
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1 is no folder of recordings; give one with --recordings, or leave it out."),
                    {folder}});
        addFilesOf(folder, true, search.m_files);
    }
    return search;
}

std::string RecordingSearch::hashOf(const std::string &path, const JobControl &control)
{
    const auto known = m_hashes.find(path);
    if (known != m_hashes.end())
        return known->second;
    const std::string hash
        = sha256OfFile(path, [&](std::uintmax_t) { return !control.stopRequested(); });
    if (!control.stopRequested())
        m_hashes[path] = hash;
    return hash;
}

std::string RecordingSearch::pathOf(const RecordedInput &input,
    const std::vector<std::string> &candidates, const JobControl &control)
{
    const auto isIt
        = [&](const std::string &path) { return hashOf(path, control) == input.sha256; };
    for (const std::string &path : candidates)
        if (isNamed(path, input.file) && isIt(path))
            return path;
    for (const auto &[path, hash] : m_hashes)
        if (hash == input.sha256 && std::ranges::find(candidates, path) != candidates.end())
            return path;
    for (const std::string &path : candidates)
        if (!control.stopRequested() && !m_hashes.contains(path) && hasReader(path) && isIt(path))
            return path;
    return {};
}

Error RecordingSearch::notFound(const RecordedInput &input,
    const std::vector<std::string> &candidates, const std::string &folder)
{
    const auto named = std::ranges::find_if(
        candidates, [&](const std::string &path) { return isNamed(path, input.file); });
    if (named != candidates.end())
        return {ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The recording %1 of the results in %2 was changed since: its SHA-256 is %3 and not %4; give the folder that holds it as it was with --recordings."),
                {*named, folder, hashOf(*named, {}), input.sha256}},
            {}, 0};
    return {ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The recording %1 (SHA-256 %3) of the results in %2 was not found there nor beside; give the folder that holds it, under whatever name, with --recordings."),
            {input.file, folder, input.sha256}},
        {}, 0};
}

Result<std::vector<std::string>> RecordingSearch::find(
    const EarlierRun &run, const JobControl &control)
{
    std::vector<std::string> candidates;
    addFilesOf(run.folder, true, candidates);
    addFilesOf(besideOf(run.folder), false, candidates);
    candidates.insert(candidates.end(), m_files.begin(), m_files.end());
    std::vector<std::string> paths;
    std::vector<Error> missing;
    for (const RecordedInput &input : run.inputs) {
        paths.push_back(pathOf(input, candidates, control));
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {});
        if (paths.back().empty())
            missing.push_back(notFound(input, candidates, run.folder));
    }
    if (!missing.empty())
        return tl::unexpected<Error>(asOneError(std::move(missing)));
    return paths;
}

} // namespace dyncal
