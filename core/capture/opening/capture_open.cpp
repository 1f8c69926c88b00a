// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/capture_open.h"

#include "core/base/free_memory.h"
#include "core/capture/capture_seal.h"
#include "core/capture/joined_captures.h"
#include "core/capture/opening/channel_files.h"
#include "core/capture/opening/folder_files.h"
#include "core/capture/opening/format_registry.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// One file to read. A file that was named, not found in a folder, must be read or be reported.
struct Candidate
{
    std::string path;
    bool named = true;
};

/// In a folder other files are normal (info); a recording that cannot be read is not (caution).
Finding skippedFile(const Error &error)
{
    const bool foreign = error.findingId == "CAP-001";
    return {.id = "CAP-024",
        .severity = foreign ? Severity::Info : Severity::Caution,
        .message
        = {DYNCAL_TEXT("core", "A file of the folder was left out. %M1"), {}, {error.message}}};
}

/// Joins files as they come and collects what went wrong with any of them.
class CaptureJoiner
{
public:
    void add(const Candidate &file, Result<CaptureSet> part)
    {
        if (part)
            m_set = joinedCaptures(std::move(m_set), std::move(*part));
        else if (file.named || part.error().kind == ErrorKind::Internal) // no shot is lost silently
            addProblem(part.error());
        else
            m_set.findings.push_back(skippedFile(part.error()));
    }

    void addProblem(const Error &error) { m_problems.push_back(error); }

    Result<CaptureSet> finish(const ImportSettings &settings)
    {
        if (!m_problems.empty())
            return tl::unexpected(joinedProblem());
        if (m_set.shots.empty())
            return tl::unexpected(nothingRead());
        if (settings.channelFiles == kJoinChannelFiles)
            joinChannelFiles(m_set);
        return std::move(m_set);
    }

private:
    Error joinedProblem() const
    {
        Error joined = m_problems.front();
        if (m_problems.size() == 1)
            return joined;
        joined.message = {DYNCAL_TEXT("core", "%1 of the inputs cannot be read:"),
            {std::to_string(m_problems.size())}};
        for (const Error &problem : m_problems)
            joined.message.below.push_back(problem.message);
        return joined;
    }

    Error nothingRead() const
    {
        Message message{
            DYNCAL_TEXT("core", "No recording was found in the inputs; readable are: %1."),
            {readableFormatsText()}};
        for (const Finding &finding : m_set.findings)
            message.below.push_back(finding.message);
        return {ErrorKind::FileUnreadable, std::move(message), "CAP-001", 0};
    }

    CaptureSet m_set;
    std::vector<Error> m_problems;
};

/// The files that `paths` name; folders give theirs. What cannot be listed is a problem.
std::vector<Candidate> candidates(const std::vector<std::string> &paths, CaptureJoiner &joiner)
{
    std::vector<Candidate> files;
    for (const std::string &path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            files.push_back({path, true});
        } else if (const auto found = filesOfFolder(path); found) {
            for (const std::string &file : *found)
                files.push_back({file, false});
        } else {
            joiner.addProblem(found.error());
        }
    }
    return files;
}

using ReadOne
    = Result<CaptureSet> (*)(const std::string &, const ImportSettings &, const JobControl &);

/// Reads every file with `readOne` and joins what they hold.
Result<CaptureSet> joinCaptures(const std::vector<std::string> &paths,
    const ImportSettings &settings, const JobControl &control, ReadOne readOne)
{
    if (const auto known = checkFormatName(settings); !known)
        return tl::unexpected(known.error());
    CaptureJoiner joiner;
    const std::vector<Candidate> files = candidates(paths, joiner);
    for (std::size_t i = 0; i < files.size(); ++i) {
        Result<CaptureSet> part = readOne(files[i].path, settings, control.part(i, files.size()));
        if (!part && part.error().kind == ErrorKind::Cancelled)
            return part;
        joiner.add(files[i], std::move(part));
    }
    return joiner.finish(settings);
}

/// What a reader and its helper process may need before they can tell what is wrong with a file.
constexpr std::size_t kReadingBytes = std::size_t(256) << 20U;

/// Libraries that lack memory report a damaged file.
Error inDoubt(const Error &error, const std::string &path)
{
    std::error_code unknown;
    if (error.kind != ErrorKind::FileUnreadable || isMemoryLeft(kReadingBytes)
        || !fs::exists(path, unknown))
        return error;
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "%1 could not be read, and there is not enough memory to tell whether the file is at fault; close other programs or raise the memory limit."),
            {path}},
        {}, 0};
}

} // namespace

Result<CaptureSet> openCapture(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const ImportSettings own = settingsOfFile(settings, path);
    const Result<const CaptureFormat *> format = formatOf(path, own);
    if (!format)
        return tl::unexpected(inDoubt(format.error(), path));
    const InputFile input = stampedInput(path, (*format)->id);
    Result<CaptureSet> set = (*format)->read(path, own, control);
    if (!set)
        return tl::unexpected(inDoubt(set.error(), path));
    set->inputs = {input};
    for (std::size_t i = 0; i < set->shots.size(); ++i) {
        set->shots[i].input = 0;
        set->shots[i].inFile = static_cast<Index>(i) + 1;
    }
    return set;
}

Result<CaptureSet> openCaptures(const std::vector<std::string> &paths,
    const ImportSettings &settings, const JobControl &control)
{
    return joinCaptures(paths, settings, control, &openCapture);
}

Result<CaptureSet> readCapture(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    Result<CaptureSet> set = openCapture(path, settings, control.part(0, 2));
    if (!set)
        return set;
    return sealCaptures(std::move(*set), control.part(1, 2));
}

Result<CaptureSet> readCaptures(const std::vector<std::string> &paths,
    const ImportSettings &settings, const JobControl &control)
{
    Result<CaptureSet> set = joinCaptures(paths, settings, control, &readCapture);
    if (!set)
        return set;
    return sealCaptures(std::move(*set)); // all hashes are there: only compares the inputs
}

} // namespace dyncal
