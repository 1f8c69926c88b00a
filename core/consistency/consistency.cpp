// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/consistency.h"

#include "core/consistency/consistency_findings.h"
#include "core/consistency/fault_isolation.h"
#include "core/consistency/gathered_evidence.h"
#include "core/consistency/shot_ways.h"

#include <algorithm>
#include <memory>

namespace dyncal {
namespace {

/// The shot whose sensitivity lies farthest from the others', as summarise() compared them.
void addShots(const ResponseResult &response, std::vector<WayComparison> &checks)
{
    WayComparison head{.of = Compared::Shots,
        .a = Way::OneShot,
        .b = Way::OtherShots,
        .unit = response.sensitivityUnit};
    const auto &farthest = response.summary.farthest;
    if (!farthest) {
        head.missing = Message{
            DYNCAL_TEXT("core", "It needs two shots at least whose sensitivities are known."), {}};
    } else {
        head.shot = farthest->shot;
        head.value_a = farthest->value;
        head.value_b = farthest->others;
        head.u = farthest->u;
    }
    checks.push_back(std::move(head));
}

/// Mean step of every level that is named, from low to high.
std::vector<double> stepsOfLevels(const CaptureSet &set, const ShockConditionsSet &shock)
{
    std::vector<double> means;
    for (const ShotLevel level : {ShotLevel::Low, ShotLevel::Medium, ShotLevel::High}) {
        double sum = 0.0;
        Index count = 0;
        for (const ShockConditions &shot : shock.shots) {
            if (set.shots.at(static_cast<std::size_t>(shot.shot - 1)).level != level
                || !shot.step_Pa)
                continue;
            sum += *shot.step_Pa;
            ++count;
        }
        if (count > 0)
            means.push_back(sum / static_cast<double>(count));
    }
    return means;
}

void addLevels(
    const CaptureSet &set, const ShockConditionsSet &shock, std::vector<WayComparison> &checks)
{
    const std::vector<double> means = stepsOfLevels(set, shock);
    WayComparison head{.of = Compared::Levels, .a = Way::Names, .b = Way::Steps};
    if (means.size() < 2)
        head.missing = Message{
            DYNCAL_TEXT("core", "It needs shots of two levels whose steps are known."), {}};
    head.isInOrder = std::is_sorted(means.begin(), means.end());
    checks.push_back(std::move(head));
}

/// CHK-006, once for all shots.
void addOtherUnit(const std::vector<std::unique_ptr<ShotEvidence>> &evidence, Findings &findings)
{
    for (const auto &shot : evidence) {
        if (shot->otherUnitOfCard.empty())
            continue;
        findings.push_back({.id = "CHK-006",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "The card of the sensor states its sensitivity in %1, this calibration gives it in %2: one of the two units is wrong, and the values are not compared. Check import.unit and the card."),
                {shot->otherUnitOfCard, shot->sensitivityUnit}},
            .causes = {FindingCause::Scale}});
        return;
    }
}

const ShotSensitivity *sensitivityOf(const ResponseResult &response, Index shot)
{
    const auto found = std::ranges::find(response.shots, shot, &ShotSensitivity::shot);
    return found != response.shots.end() ? &*found : nullptr;
}

} // namespace

ConsistencyResult compareWays(const CaptureSet &set, const ShockSettings &settings,
    const ShockConditionsSet &shock, const ResponseResult &response,
    const std::vector<StatedUncertainty> &stated)
{
    ConsistencyResult result;
    if (!settings.enabled)
        return result;
    std::vector<std::unique_ptr<ShotEvidence>> evidence;
    std::vector<std::unique_ptr<ShotWays>> ways;
    for (const ShockConditions &conditions : shock.shots) {
        evidence.push_back(std::make_unique<ShotEvidence>(
            gatherEvidence(set, settings, conditions, sensitivityOf(response, conditions.shot))));
        ways.push_back(std::make_unique<ShotWays>(*evidence.back(), stated));
    }
    const ComparedShots compared(ways);
    result.checks = compared.comparisons();
    addShots(response, result.checks);
    addLevels(set, shock, result.checks);
    result.findings
        = judgeConsistency(compared, result.checks, settings, !response.summary.shotsAgree);
    addOtherUnit(evidence, result.findings);
    return result;
}

} // namespace dyncal
