// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/recheck/earlier_run.h"

#include <string>
#include <vector>

namespace dyncal {

/// Recordings under the names that they had when the earlier run read them: settings of a recipe
/// (`import.files`), files of single channels and labels go by the name. What was renamed since is
/// a link in a folder for temporary files, which is gone with this object; the recording itself
/// stays untouched.
class NamedRecordings
{
public:
    /// `paths`: where each of `inputs` is now. Fails (FileUnreadable) if no link can be made.
    static Result<NamedRecordings> of(
        const std::vector<RecordedInput> &inputs, std::vector<std::string> paths);

    NamedRecordings(NamedRecordings &&other) noexcept;
    NamedRecordings &operator=(NamedRecordings &&) = delete;
    NamedRecordings(const NamedRecordings &) = delete;
    NamedRecordings &operator=(const NamedRecordings &) = delete;
    ~NamedRecordings();

    const std::vector<std::string> &paths() const { return m_paths; }

private:
    explicit NamedRecordings(std::vector<std::string> paths);
    Result<void> link(std::size_t i, const std::string &name);

    std::string m_folder; ///< empty: nothing was renamed
    std::vector<std::string> m_paths;
};

} // namespace dyncal
