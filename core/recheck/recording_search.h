// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/recheck/earlier_run.h"

#include <map>
#include <string>
#include <vector>

namespace dyncal {

/// Finds recordings by their content, whatever they are called now. What was hashed once is
/// remembered, so that one search serves many runs.
class RecordingSearch
{
public:
    /// Looks through the folders and all below them, hidden ones left out, links not followed.
    /// Fails (FileUnreadable) if one is no folder.
    static Result<RecordingSearch> in(const std::vector<std::string> &folders);

    /// Paths of the recordings of a run, in their order: from its folder, from beside it, and from
    /// the folders of the search. A file of the same name is looked at first; others are hashed
    /// only where a reader knows their format. Fails (FileUnreadable), naming every file that is
    /// missing, with its hash, or that is there by its name and has another one; (Cancelled) on
    /// request.
    Result<std::vector<std::string>> find(const EarlierRun &run, const JobControl &control = {});

private:
    std::string hashOf(const std::string &path, const JobControl &control);
    std::string pathOf(const RecordedInput &input, const std::vector<std::string> &candidates,
        const JobControl &control);
    Error notFound(const RecordedInput &input, const std::vector<std::string> &candidates,
        const std::string &folder);

    std::vector<std::string> m_files;
    std::map<std::string, std::string> m_hashes; ///< by path
};

} // namespace dyncal
