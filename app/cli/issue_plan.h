// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "app/cli/issuing.h"

#include <functional>
#include <optional>
#include <string>

namespace dyncal {

/// What came of one job that was to be issued: its certificate, or what keeps it a draft.
struct IssueAnswer
{
    std::optional<IssuedCertificate> issued;
    Findings findings; ///< what keeps it a draft; beside a certificate its cautions
};
using IssueJob = std::function<Result<IssueAnswer>(ProjectState)>;

/// Whether the file is a plan of a batch and no project, by its name (.jsonl).
bool isPlan(const std::string &path);

/// Issues every sensor of the plan that is ready, in the plan's order; the others stay drafts, each
/// with its reason. From here on the program works in the plan's folder. The exit code: Blocked
/// where one was left. Stops on Ctrl-C.
int issuePlan(const std::string &path, const IssueJob &issueJob, bool json);

} // namespace dyncal
