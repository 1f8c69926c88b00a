// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_checks.h"

#include "core/base/number_text.h"
#include "core/certificate/certificate_words.h"
#include "core/consistency/way_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dyncal {
namespace {

constexpr const char *kPercent = "\u00a0%"; ///< stays in the line of its number

/// All comparisons of one quantity by the same two ways.
struct Group
{
    const WayComparison *first = nullptr;
    int made = 0;
    int against = 0;
    int missing = 0;
    double largest = 0.0; ///< difference over u
    double detectable = 0.0; ///< relative; 0 = not a number
};

std::vector<Group> groupsOf(const std::vector<WayComparison> &checks)
{
    std::vector<Group> groups;
    for (const WayComparison &check : checks) {
        auto group = std::ranges::find_if(groups, [&](const Group &g) {
            return g.first->of == check.of && g.first->a == check.a && g.first->b == check.b;
        });
        if (group == groups.end())
            group = groups.insert(groups.end(), Group{&check});
        group->missing += check.isMade() ? 0 : 1;
        group->made += check.isMade() ? 1 : 0;
        group->against += check.agrees() ? 0 : 1;
        if (!check.isMade() || !std::isfinite(check.u))
            continue;
        group->largest = std::max(group->largest, std::abs(check.difference() / check.u));
        group->detectable
            = std::max(group->detectable, check.smallestDetectable() / std::abs(check.value_b));
    }
    return groups;
}

Message verdictOf(const Group &group)
{
    if (group.made == 0) // the reason is the verdict
        return *group.first->missing;
    if (group.against == 0)
        return {DYNCAL_TEXT("core", "agree"), {}};
    return {DYNCAL_TEXT("core", "%1 contradict each other"), {std::to_string(group.against)}};
}

std::vector<Message> rowOf(const Group &group)
{
    const bool hasNumbers = group.detectable > 0.0;
    return {comparedText(group.first->of), wayText(group.first->a), wayText(group.first->b),
        inNumbers(std::to_string(group.made)),
        hasNumbers ? inNumbers(numberText(group.largest, 2)) : dash(),
        hasNumbers ? inNumbers(numberText(100.0 * group.detectable, 2) + kPercent) : dash(),
        verdictOf(group)};
}

} // namespace

void addCheckTable(const CalibrationResults &results, CertificateSection &section)
{
    if (!results.checks || results.checks->checks.empty()) {
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core", "No quantity was known in two independent ways."), {}});
        return;
    }
    CertificateTable table;
    table.id = "checks";
    table.caption = {
        DYNCAL_TEXT("core",
            "Independent ways to one quantity, compared within the combined uncertainty of their difference (contradiction from 3.6 u on)"),
        {}};
    table.columns = {{{DYNCAL_TEXT("core", "Quantity"), {}}, false},
        {{DYNCAL_TEXT("core", "One way"), {}}, false},
        {{DYNCAL_TEXT("core", "Other way"), {}}, false}, {{DYNCAL_TEXT("core", "Made"), {}}, true},
        {{DYNCAL_TEXT("core", "Largest difference, u"), {}}, true},
        {{DYNCAL_TEXT("core", "Fault seen in 90 %"), {}}, true},
        {{DYNCAL_TEXT("core", "Verdict"), {}}, false}};
    for (const Group &group : groupsOf(results.checks->checks))
        table.rows.push_back(rowOf(group));
    section.tables.push_back(std::move(table));
}

} // namespace dyncal
