// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/page_standing.h"

#include "core/pipeline/stage_table.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

/// The stage that each page is opened for.
constexpr std::array<StageId, kPageCount> kOpenedFor{StageId::Captures, StageId::Shock,
    StageId::Window, StageId::Spectrum, StageId::Components, StageId::ModelInput,
    StageId::Decomposition, StageId::Model, StageId::Checks, StageId::Uncertainty,
    StageId::Comparison, StageId::Response};

/// Where something is seen that went wrong in a stage and has no id of its own.
Page pageOfStage(StageId stage)
{
    const auto found = std::ranges::find(kOpenedFor, stageOf(stage).shownWith);
    return static_cast<Page>(found - kOpenedFor.begin());
}

/// A page also answers for the stages that it shows beside another: what is wrong with the model
/// is seen, and mended, where the order is chosen.
bool concerns(const Finding &finding, Page page, const WorkState &work)
{
    if (pageOf(finding, work) == page)
        return true;
    const std::optional<StageId> stage = stageOfFinding(finding.id);
    const std::vector<StageId> stages = stagesOf(page);
    return stage && std::ranges::find(stages, *stage) != stages.end();
}

const Finding *ownBlock(Page page, const WorkState &work)
{
    const auto found = std::ranges::find_if(work.findings, [&](const Finding &finding) {
        return finding.severity == Severity::Block && concerns(finding, page, work);
    });
    return found == work.findings.end() ? nullptr : &*found;
}

bool anyStage(Page page, const WorkState &work, StageStatus status)
{
    return std::ranges::any_of(stagesOf(page),
        [&](StageId stage) { return work.stages[static_cast<std::size_t>(stage)] == status; });
}

/// Whether what a page is opened for is computed from what the finding speaks of.
bool restsOn(Page page, const Finding &finding)
{
    const std::optional<StageId> stage = stageOfFinding(finding.id);
    return stage && *stage <= stageOf(stagesOf(page).front()).follows;
}

/// A finding of another page that keeps this one from standing: of an earlier page whose result
/// this one is computed from, or whatever stopped the run.
const Finding *foreignBlock(Page page, const WorkState &work)
{
    const bool stopped = anyStage(page, work, StageStatus::Blocked);
    for (const Finding &finding : work.findings) {
        if (finding.severity != Severity::Block)
            continue;
        const bool isEarlier = pageOf(finding, work) < page;
        if (page == Page::Certificate || stopped || (isEarlier && restsOn(page, finding)))
            return &finding;
    }
    return nullptr;
}

PageStanding unsettled(StageStatus status)
{
    return {.status = status};
}

PageStanding ofResults(Page page, const WorkState &work)
{
    PageStanding standing{.cautions = openCautions(work, page)};
    if (ownBlock(page, work)) {
        standing.status = StageStatus::Blocked;
    } else if (const Finding *block = foreignBlock(page, work)) {
        standing.status = StageStatus::Blocked;
        standing.blockedBy = pageOf(*block, work);
    } else if (anyStage(page, work, StageStatus::Blocked)) {
        standing.status = StageStatus::Blocked;
        if (work.stopped && pageOfStage(work.failedStage) != page)
            standing.blockedBy = pageOfStage(work.failedStage);
    } else if (anyStage(page, work, StageStatus::NotStarted)) {
        standing.status = StageStatus::NotStarted;
    } else {
        standing.status = standing.cautions > 0 ? StageStatus::DoneWithCautions : StageStatus::Done;
    }
    return standing;
}

/// The certificate speaks for all stages: it waits for every one of them.
PageStanding ofCertificate(const WorkState &work)
{
    for (const StageStatus status : {StageStatus::Computing, StageStatus::Stale})
        if (std::ranges::find(work.stages, status) != work.stages.end())
            return unsettled(status);
    PageStanding standing = ofResults(Page::Certificate, work);
    standing.cautions = openCautions(work);
    const auto wrong = std::ranges::count_if(work.unfilled, &CertificateField::wrong);
    standing.wrongFields = static_cast<int>(wrong);
    standing.emptyFields = static_cast<int>(std::ssize(work.unfilled) - wrong);
    if (standing.status == StageStatus::Done || standing.status == StageStatus::DoneWithCautions) {
        standing.status = standing.cautions > 0 ? StageStatus::DoneWithCautions : StageStatus::Done;
        if (!work.unfilled.empty())
            standing.status = StageStatus::Incomplete;
    }
    return standing;
}

} // namespace

std::vector<StageId> stagesOf(Page page)
{
    const StageId first = kOpenedFor[static_cast<std::size_t>(page)];
    std::vector<StageId> stages{first};
    for (int i = 0; i < kStageCount; ++i) {
        const Stage &stage = stageOf(static_cast<StageId>(i));
        if (stage.awaited && stage.shownWith == first && stage.id != first)
            stages.push_back(stage.id);
    }
    if (page == Page::Order) // what an order means is seen in its model
        stages.push_back(StageId::Model);
    return stages;
}

std::optional<Page> pageOfFinding(const std::string &id)
{
    // Those that no stage finds, or that are settled elsewhere than where they are found.
    constexpr std::pair<std::string_view, Page> kPrefixes[]{
        {"FIL-", Page::Captures}, {"PRJ-", Page::Captures}, {"NUI-", Page::Spectrum}};
    for (const auto &[prefix, page] : kPrefixes)
        if (id.starts_with(prefix))
            return page;
    const std::optional<StageId> stage = stageOfFinding(id);
    return stage ? std::optional(pageOfStage(*stage)) : std::nullopt;
}

Page pageOf(const Finding &finding, const WorkState &work)
{
    return pageOfFinding(finding.id).value_or(pageOfStage(work.failedStage));
}

bool isAccepted(const Finding &finding, const std::vector<Acknowledgement> &accepted)
{
    return std::ranges::any_of(accepted, [&](const Acknowledgement &entry) {
        return entry.finding == finding.id && (entry.shot == 0 || entry.shot == finding.shot);
    });
}

int openCautions(const WorkState &work, std::optional<Page> page)
{
    return static_cast<int>(std::ranges::count_if(work.findings, [&](const Finding &finding) {
        return finding.severity == Severity::Caution && !isAccepted(finding, work.accepted)
            && (!page || concerns(finding, *page, work));
    }));
}

PageStanding standingOf(Page page, const WorkState &work)
{
    if (page == Page::Certificate)
        return ofCertificate(work);
    for (const StageStatus status : {StageStatus::Computing, StageStatus::Stale})
        if (anyStage(page, work, status))
            return unsettled(status);
    return ofResults(page, work);
}

const Finding *blockOf(Page page, const WorkState &work)
{
    const Finding *own = ownBlock(page, work);
    return own ? own : foreignBlock(page, work);
}

} // namespace dyncal
