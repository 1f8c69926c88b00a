// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/findings_json.h"

#include "app/cli/spoken.h"

#include <cmath>

namespace dyncal {
namespace {

using Json = nlohmann::json;

Json orNull(const std::optional<double> &value)
{
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

} // namespace

Json findingsJson(const Findings &findings)
{
    Json list = Json::array();
    for (const Finding &finding : findings)
        list.push_back({{"id", finding.id}, {"severity", severityName(finding.severity)},
            {"shot", finding.shot > 0 ? Json(finding.shot) : Json(nullptr)},
            {"channel", finding.channel.empty() ? Json(nullptr) : Json(finding.channel)},
            {"time_s", orNull(finding.time_s)}, {"message", spoken(finding.message)},
            {"value", orNull(finding.value)}, {"limit", orNull(finding.limit)}});
    return list;
}

Json textOrNull(const std::string &text)
{
    return text.empty() ? Json() : Json(text);
}

} // namespace dyncal
