// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/finding_changes.h"

#include "core/results/results_reading.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using FoundList = std::vector<StatedFinding>;

/// A file of a folder that was left out: of the folder that was given then, not of the recordings.
constexpr const char *kOfTheFolder = "CAP-024";

bool isDrawn(const StatedFinding &finding)
{
    return finding.id == "SHK-012" || finding.id == "UNC-003";
}

StatedFinding statedFinding(const nlohmann::json &json)
{
    const double shot = numberAt(json, "shot");
    return {textAt(json, "id"), textAt(json, "severity"),
        std::abs(shot) < 1e9 ? static_cast<Index>(shot) : 0, textAt(json, "message")};
}

FoundList statedFindings(const nlohmann::json &results)
{
    FoundList findings;
    for (const nlohmann::json &one : valueAt(results, "findings"))
        if (textAt(one, "id") != kOfTheFolder)
            findings.push_back(statedFinding(one));
    return findings;
}

/// Those of `findings` that are not in `others`, each as often as it is there more.
FoundList without(const FoundList &findings, FoundList others)
{
    FoundList left;
    for (const StatedFinding &one : findings) {
        const auto same = std::ranges::find_if(others, [&](const StatedFinding &other) {
            return other.id == one.id && other.severity == one.severity && other.shot == one.shot;
        });
        if (same == others.end())
            left.push_back(one);
        else
            others.erase(same);
    }
    return left;
}

} // namespace

std::string StatedFinding::text() const
{
    return id + " (" + severity + (shot > 0 ? ", shot " + std::to_string(shot) : std::string())
        + "): " + message;
}

FindingChanges findingChanges(
    const nlohmann::json &issued, const nlohmann::json &now, RecheckDepth depth)
{
    FoundList before = statedFindings(issued);
    FoundList after = statedFindings(now);
    if (depth == RecheckDepth::ToEvidence)
        for (FoundList *list : {&before, &after})
            std::erase_if(*list, isDrawn);
    return {without(after, before), without(before, after)};
}

std::string blockOf(const nlohmann::json &results)
{
    const nlohmann::json &error = valueAt(results, "error");
    const std::string id = textAt(error, "finding");
    if (!textAt(error, "message").empty())
        return (id.empty() ? std::string() : id + ": ") + textAt(error, "message");
    for (const StatedFinding &one : statedFindings(results))
        if (one.severity == "block")
            return one.id + ": " + one.message;
    return {};
}

} // namespace dyncal
