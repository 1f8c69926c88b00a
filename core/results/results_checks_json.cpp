// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_checks_json.h"

namespace dyncal {
namespace {

JsonRecord::Json checkJson(const WayComparison &check)
{
    JsonRecord record;
    record.set("of", comparedName(check.of));
    record.set("ways", {wayName(check.a), wayName(check.b)});
    if (check.shot > 0)
        record.set("shot", check.shot);
    else
        record.missing("shot", "Concerns all shots.");
    record.text("channel", check.channel, "Concerns no single channel.");
    const std::string reason
        = check.isMade() ? "Levels are names, not numbers." : english(*check.missing);
    record.number("value_a", check.value_a, reason);
    record.number("value_b", check.value_b, reason);
    record.number("difference", check.difference(), reason);
    record.number("u", check.u, reason);
    record.number("e_n", check.e_n(), reason);
    record.number("smallest_detectable", check.smallestDetectable(), reason);
    record.text("unit", check.unit, "Has none.");
    if (check.isMade())
        record.set("agree", check.agrees());
    else
        record.missing("agree", reason);
    return record.take();
}

} // namespace

void addChecks(JsonRecord &root, const ResultsContext &context)
{
    const ConsistencyResult *result = context.results().checks.get();
    if (!result) {
        root.missing("checks", context.whyMissing());
        return;
    }
    JsonRecord::Json list = JsonRecord::Json::array();
    for (const WayComparison &check : result->checks)
        list.push_back(checkJson(check));
    root.set("checks", std::move(list));
}

} // namespace dyncal
