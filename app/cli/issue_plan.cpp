// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/issue_plan.h"

#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/findings_json.h"
#include "app/cli/spoken.h"

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/batch/batch_plan.h"
#include "core/batch/planned_inputs.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

using Json = nlohmann::json;

Result<ProjectState> plannedJob(const PlannedSensor &sensor)
{
    if (!sensor.obstacle.empty())
        return fail(ErrorKind::DataBlocked, {"%1", {sensor.obstacle}});
    const Result<std::vector<std::string>> paths = plannedPaths(".", sensor);
    if (!paths)
        return tl::unexpected<Error>(paths.error());
    const Result<Recipe> recipe = plannedRecipe(sensor);
    if (!recipe)
        return tl::unexpected<Error>(recipe.error());
    Result<CaptureSet> set = readForCalibration({sensor.source}, *recipe);
    if (!set)
        return tl::unexpected<Error>(set.error());
    if (const auto checked = checkReadInputs(*set, *paths, sensor); !checked)
        return tl::unexpected<Error>(checked.error());
    return ProjectState{std::make_shared<const CaptureSet>(std::move(*set)), *recipe};
}

/// The sensors of one plan as they are issued, told one by one.
class PlanIssue
{
public:
    PlanIssue(const IssueJob &issueJob, bool json)
        : m_issueJob(issueJob)
        , m_json(json)
    {
    }

    /// Whether to go on.
    bool issue(const PlannedSensor &sensor)
    {
        const Result<ProjectState> job = plannedJob(sensor);
        const Result<IssueAnswer> answer
            = job ? m_issueJob(*job) : Result<IssueAnswer>(tl::unexpected<Error>(job.error()));
        if (!answer && answer.error().kind == ErrorKind::Cancelled) {
            m_isStopped = true;
            return false;
        }
        if (!answer)
            leave(sensor, spoken(answer.error().message), {});
        else if (!answer->issued)
            leave(sensor, reasonOf(answer->findings), answer->findings);
        else
            tell(sensor, *answer->issued, answer->findings);
        return true;
    }

    int conclude() const
    {
        if (m_json)
            std::cout << jsonText({{"sensors", m_answers}});
        else
            std::cout << m_issued << " issued, " << m_left << " left as drafts.\n";
        if (m_isStopped)
            return report(Error{ErrorKind::Cancelled, {}, {}, 0});
        return static_cast<int>(m_left > 0 ? ExitCode::Blocked : ExitCode::Done);
    }

private:
    static std::string reasonOf(const Findings &obstacles)
    {
        const std::string first = obstacles.front().id + ": " + spoken(obstacles.front().message);
        const std::size_t more = obstacles.size() - 1;
        return more == 0 ? first : first + " (and " + std::to_string(more) + " more)";
    }

    void tell(
        const PlannedSensor &sensor, const IssuedCertificate &issued, const Findings &cautions)
    {
        ++m_issued;
        m_answers.push_back({{"id", sensor.id}, {"number", issued.record.number},
            {"state", certificateStateName(issued.record.state)}, {"folder", issued.folder},
            {"reason", nullptr}, {"findings", findingsJson(cautions)}});
        reportFindings(cautions);
        if (!m_json)
            std::cout << presentable(sensor.id) << ": certificate " << issued.record.number << ", "
                      << presentable(issued.folder) << std::endl;
    }

    void leave(const PlannedSensor &sensor, const std::string &reason, const Findings &obstacles)
    {
        ++m_left;
        m_answers.push_back({{"id", sensor.id}, {"number", nullptr}, {"state", "draft"},
            {"folder", nullptr}, {"reason", reason}, {"findings", findingsJson(obstacles)}});
        std::cerr << presentable(sensor.id) << " stays a draft: " << presentable(reason) << '\n';
    }

    const IssueJob &m_issueJob;
    bool m_json;
    bool m_isStopped = false;
    int m_issued = 0;
    int m_left = 0;
    Json m_answers = Json::array();
};

} // namespace

bool isPlan(const std::string &path)
{
    return path.ends_with(".jsonl");
}

int issuePlan(const std::string &path, const IssueJob &issueJob, bool json)
{
    const Result<BatchPlan> plan = readPlan(path);
    if (!plan)
        return report(plan.error());
    std::error_code failed;
    std::filesystem::current_path(folderOfPlan(path), failed);
    if (failed)
        return report(Error{ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "The folder %1 cannot be entered; check that you may."),
                {folderOfPlan(path)}},
            {}, 0});
    PlanIssue issue(issueJob, json);
    for (const PlannedSensor &sensor : *plan)
        if (!issue.issue(sensor))
            break;
    return issue.conclude();
}

} // namespace dyncal
