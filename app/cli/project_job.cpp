// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/project_job.h"

#include "app/base/interrupt.h"
#include "app/cli/console.h"

#include "core/capture/capture_seal.h"
#include "ui/session/project_file.h"

namespace dyncal {

Result<ProjectState> readProjectJob(const std::string &path)
{
    const QString name = QString::fromStdString(path);
    if (name.toStdString() != path)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "The name of project %1 is not valid UTF-8; rename the project."),
                {path}});
    const Result<ProjectFile> file = readProjectFile(name);
    if (!file)
        return tl::unexpected<Error>(file.error());
    Result<ProjectState> project = readProjectJob(*file);
    if (const std::optional<Finding> older = olderVersion(*file); project && older)
        reportFindings({*older});
    return project;
}

Result<ProjectState> readProjectJob(const ProjectFile &file)
{
    ProgressLine progress("Reading");
    const JobControl control{interruptToken(), progress.sink()};
    Result<ProjectState> project = openProject(file, control);
    if (!project)
        return project;
    Result<CaptureSet> set = sealCaptures(*project->captures, control);
    if (!set)
        return tl::unexpected<Error>(set.error());
    project->captures = std::make_shared<const CaptureSet>(std::move(*set));
    return project;
}

} // namespace dyncal
