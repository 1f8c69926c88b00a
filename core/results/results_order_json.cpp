// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_order_json.h"

namespace dyncal {
namespace {

using Json = JsonRecord::Json;

Json sentences(const std::vector<Message> &messages)
{
    Json list = Json::array();
    for (const Message &message : messages)
        list.push_back(english(message));
    return list;
}

/// Columns of equal length: one entry per oscillating pole and order.
Json stabilityJson(const std::vector<OrderPole> &poles)
{
    Json table = {{"order", Json::array()}, {"frequency_hz", Json::array()},
        {"damping_ratio", Json::array()}, {"stability", Json::array()},
        {"stands_out", Json::array()}};
    for (const OrderPole &pole : poles) {
        table["order"].push_back(pole.order);
        table["frequency_hz"].push_back(finiteOrNull(pole.frequency_Hz));
        table["damping_ratio"].push_back(finiteOrNull(pole.dampingRatio));
        table["stability"].push_back(poleStabilityName(pole.stability));
        table["stands_out"].push_back(pole.standsOut);
    }
    return table;
}

Json spreadJson(const OrderSpread &spread)
{
    const char *none = "Not determined.";
    JsonRecord record;
    record.set("from_order", spread.fromOrder);
    record.set("to_order", spread.toOrder);
    record.number("frequency_hz", spread.frequency_Hz, none);
    record.number("frequency_spread_hz", spread.frequencySpread_Hz, none);
    record.number("damping_ratio", spread.dampingRatio, none);
    record.number("damping_spread", spread.dampingSpread, none);
    return record.take();
}

} // namespace

void addOrderEvidence(JsonRecord &section, const ResultsContext &context)
{
    section.text("adopted_reason", context.recipe.realization.adoptedReason,
        "The recipe gives no reason for the order.");
    const auto evidence = context.results().evidence;
    if (!evidence) {
        for (const char *key :
            {"why", "stability", "fit_by_order_percent", "leave_one_out_percent", "spread"})
            section.missing(key, context.whyMissing());
        return;
    }
    section.set("why", sentences(evidence->words));
    section.set("stability", stabilityJson(evidence->poles));
    section.numbers(
        "fit_by_order_percent", evidence->fit_percent, "The simulation of the model diverges.");
    section.numbers("leave_one_out_percent", evidence->crossShot_percent,
        evidence->crossShot_percent.size() > 0
            ? "The poles of the other shots grow."
            : "Fewer than two shots, or their average, leave no shot to compare with.");
    if (evidence->spread)
        section.set("spread", spreadJson(*evidence->spread));
    else
        section.missing("spread", "No oscillating pole stands out at the suggested order.");
}

} // namespace dyncal
