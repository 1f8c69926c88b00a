// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/finding.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dyncal {

const char *findingCauseName(FindingCause cause)
{
    constexpr std::array kNames{"drift", "shots", "typed", "rate", "scale", "distance", "gas",
        "temperature", "humidity", "attenuation", "pressure", "delay", "echo", "front", "noise",
        "order", "reference"};
    return kNames[static_cast<std::size_t>(cause)];
}

const char *severityName(Severity severity)
{
    switch (severity) {
    case Severity::Info:
        return "info";
    case Severity::Caution:
        return "caution";
    case Severity::Block:
        return "block";
    }
    return "info";
}

void addOnce(Findings &findings, Finding finding)
{
    if (std::ranges::find(findings, finding) == findings.end())
        findings.push_back(std::move(finding));
}

Severity worstSeverity(const Findings &findings)
{
    Severity worst = Severity::Info;
    for (const Finding &finding : findings)
        worst = std::max(worst, finding.severity);
    return worst;
}

} // namespace dyncal
