// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

enum class Severity { Info, Caution, Block };

/// One change of the recipe that would settle a finding: what a button offers, ready to apply.
struct Correction
{
    Message label; ///< "Use 294.15 K"
    std::string key; ///< dotted path of the recipe: "shock.t1_k"
    std::string value; ///< as JSON: "294.15"

    bool operator==(const Correction &) const = default;
};

/// What a finding says may be wrong; several where the data cannot tell them apart, the likeliest
/// first.
enum class FindingCause {
    Drift,
    Shots,
    Typed,
    Rate,
    Scale,
    Distance,
    Gas,
    Temperature,
    Humidity,
    Attenuation,
    Pressure,
    Delay,
    Echo,
    Front,
    Noise,
    Order,
    Reference ///< the reference transducer: its certificate, its chain
};

/// A result exists and the operator must see something about it. Ids are stable (findings catalogue
/// in docs/findings.md); scripts and tests key on them.
struct Finding
{
    std::string id; ///< "CAP-006"
    Severity severity = Severity::Info;
    Index shot = 0; ///< number from 1; 0 = concerns no single shot
    std::string channel = {};
    std::optional<double> time_s = std::nullopt; ///< on the record's own axis
    Message message = {};
    std::optional<double> value = std::nullopt;
    std::optional<double> limit = std::nullopt;
    std::optional<Correction> correction
        = std::nullopt; ///< where one change of the recipe would settle it
    std::vector<FindingCause> causes = {};

    bool operator==(const Finding &) const = default;
};

using Findings = std::vector<Finding>;

const char *findingCauseName(FindingCause cause); ///< "drift", ...: the words of results.json

/// "info", "caution" or "block": the words of results.json.
const char *severityName(Severity severity);

/// Adds what is not in the list already: what is the same in every shot is said once.
void addOnce(Findings &findings, Finding finding);

/// The most severe entry; Info for an empty list.
Severity worstSeverity(const Findings &findings);

} // namespace dyncal
