// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/named_recordings.h"

#include "core/base/writing/temporary_name.h"

#include <filesystem>
#include <utility>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// A name that leads nowhere else, as a file of a folder has it.
bool isPlainName(const std::string &name)
{
    return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos
        && name.find('\0') == std::string::npos;
}

/// A name in the folder for temporary files; empty where there is no such folder.
std::string newFolder(std::error_code &problem)
{
    const fs::path temporary = fs::temp_directory_path(problem);
    return problem ? std::string() : (temporary / newTemporaryName()).string();
}

} // namespace

NamedRecordings::NamedRecordings(std::vector<std::string> paths)
    : m_paths(std::move(paths))
{
}

NamedRecordings::NamedRecordings(NamedRecordings &&other) noexcept
    : m_folder(std::exchange(other.m_folder, {}))
    , m_paths(std::move(other.m_paths))
{
}

NamedRecordings::~NamedRecordings()
{
    std::error_code ignored;
    if (!m_folder.empty())
        fs::remove_all(m_folder, ignored);
}

/// Each in a folder of its own: two recordings may have had one name.
Result<void> NamedRecordings::link(std::size_t i, const std::string &name)
{
    std::error_code problem;
    if (m_folder.empty())
        m_folder = newFolder(problem);
    const fs::path own = fs::path(m_folder) / std::to_string(i + 1);
    if (!problem)
        fs::create_directories(own, problem);
    const fs::path now = problem ? fs::path() : fs::canonical(m_paths[i], problem);
    if (!problem)
        fs::create_symlink(now, own / name, problem);
    if (problem)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The recording %1 is now called %2 and cannot be read under its old name, because the folder for temporary files cannot be written to (%3); give it its old name, or set TMPDIR."),
                {name, m_paths[i], problem.message()}});
    m_paths[i] = (own / name).string();
    return {};
}

Result<NamedRecordings> NamedRecordings::of(
    const std::vector<RecordedInput> &inputs, std::vector<std::string> paths)
{
    NamedRecordings named(std::move(paths));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const bool isRenamed = fs::path(named.m_paths[i]).filename() != inputs[i].file;
        if (!isRenamed || !isPlainName(inputs[i].file))
            continue;
        if (const Result<void> linked = named.link(i, inputs[i].file); !linked)
            return tl::unexpected<Error>(linked.error());
    }
    return named;
}

} // namespace dyncal
