// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

#include <memory>
#include <optional>
#include <string>

namespace dyncal {

class FileLock;

/// Who has a project open.
struct ProjectHolder
{
    std::string name; ///< of the account; empty: not known
    std::string machine;
    std::string sinceUtc; ///< ISO 8601 with Z

    bool operator==(const ProjectHolder &) const = default;
};

/// Tells everybody that a project is open here, as long as it lives: a locked file
/// ".PROJECT.held" beside the project, which names the holder. Where the folder's locks do not
/// reach other machines (some network folders), its time is the sign of life: beat() renews it.
class ProjectHold
{
public:
    ~ProjectHold(); ///< removes the file
    ProjectHold(const ProjectHold &) = delete;
    ProjectHold &operator=(const ProjectHold &) = delete;

    void beat() const; ///< wanted every kHoldBeat_s
    const QString &file() const { return m_file; } ///< holdFile() or writtenHoldFile()

private:
    friend struct HoldAnswer;
    ProjectHold(const QString &file, std::unique_ptr<FileLock> lock);

    QString m_file;
    std::unique_ptr<FileLock> m_lock;
};

inline constexpr int kHoldBeat_s = 20;
/// A holder on another machine that has given no sign for so long has stopped.
inline constexpr int kLongestSilence_s = 90;

/// One of the two, or neither: then nobody can be told there (a folder that cannot be written to).
struct HoldAnswer
{
    std::shared_ptr<ProjectHold> hold;
    std::optional<ProjectHolder> other; ///< who has it open

    /// Holds a project by its holdFile() or writtenHoldFile() for `who`, unless somebody else does.
    /// A program that was killed holds nothing: on this machine at once, on another after
    /// kLongestSilence_s.
    static HoldAnswer at(const QString &holdFile, const ProjectHolder &who);
};

/// The file that says who holds a project; links to one project lead to one file.
QString holdFile(const QString &project);

/// That of a project once it is saved under this name: a link is replaced by the project, which is
/// then another file than the one that the link led to.
QString writtenHoldFile(const QString &project);

} // namespace dyncal
