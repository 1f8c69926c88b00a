// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/method_changes.h"

#include "core/results/results_reading.h"

#include <set>

namespace dyncal {
namespace {

std::optional<int> versionOf(const MethodVersions &versions, const std::string &step)
{
    const auto found = versions.find(step);
    return found != versions.end() ? std::optional(found->second) : std::nullopt;
}

std::vector<MethodChange> allSinceTheFirst(const MethodVersions &now)
{
    std::vector<MethodChange> changes;
    for (const auto &[step, version] : now)
        if (version > 1)
            changes.push_back({step, std::nullopt, version});
    return changes;
}

} // namespace

std::string MethodChange::text() const
{
    if (!issued)
        return step + ' ' + std::to_string(*now) + " (new)";
    return step + ' ' + std::to_string(*issued) + " -> "
        + (now ? std::to_string(*now) : std::string("no longer a step"));
}

std::optional<MethodVersions> statedMethods(const nlohmann::json &results)
{
    const nlohmann::json &stated = valueAt(valueAt(results, "software"), "method");
    if (!stated.is_object())
        return std::nullopt;
    MethodVersions versions;
    for (const auto &[step, version] : stated.items())
        if (version.is_number_integer())
            versions[step] = version.get<int>();
    return versions;
}

std::vector<MethodChange> methodChanges(
    const std::optional<MethodVersions> &issued, const MethodVersions &now)
{
    if (!issued)
        return allSinceTheFirst(now);
    std::set<std::string> steps;
    for (const MethodVersions *versions : {&*issued, &now})
        for (const auto &[step, version] : *versions)
            steps.insert(step);
    std::vector<MethodChange> changes;
    for (const std::string &step : steps) {
        const MethodChange change{step, versionOf(*issued, step), versionOf(now, step)};
        if (change.issued != change.now)
            changes.push_back(change);
    }
    return changes;
}

} // namespace dyncal
