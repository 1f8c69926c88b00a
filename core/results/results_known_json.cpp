// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_known_json.h"

#include "core/base/message.h"

#include <string>

namespace dyncal {
namespace {

void addValue(JsonRecord &record, const std::string &suffix, const ReportedValue &value,
    const std::string &why)
{
    record.number("magnitude" + suffix, value.value, why);
    record.number("u_magnitude" + suffix, value.u, why);
    record.number("k" + suffix, value.u ? std::optional(value.factor()) : std::nullopt, why);
}

void addAgainst(JsonRecord &record, KnownAgainst against, const std::string &why)
{
    if (against == KnownAgainst::Nothing)
        record.missing("against", why);
    else
        record.set("against", against == KnownAgainst::Row ? "row" : "sensitivity");
}

JsonRecord::Json knownOne(const KnownValue &known)
{
    const std::string why = known.isCompared() ? "Is compared." : english(known.missing);
    JsonRecord record;
    record.set("label", known.stated.label);
    record.text("certificate", known.stated.certificate, "None is named.");
    record.set("frequency_hz", known.stated.frequency_Hz);
    record.set("unit", known.other.unit);
    addValue(record, "", known.other, "The unit is none of a sensitivity to pressure.");
    addValue(record, "_here", known.here, why);
    addAgainst(record, known.against, why);
    record.number("difference_relative",
        known.isCompared() ? std::optional(known.difference_relative()) : std::nullopt, why);
    record.number("e_n", known.e_n, why);
    record.set("joined", known.isJoined());
    return record.take();
}

} // namespace

JsonRecord::Json knownJson(const std::vector<KnownValue> &known)
{
    JsonRecord::Json list = JsonRecord::Json::array();
    for (const KnownValue &one : known)
        list.push_back(knownOne(one));
    return list;
}

} // namespace dyncal
