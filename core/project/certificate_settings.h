// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A caution that the operator accepts, with the reason.
struct Acknowledgement
{
    std::string finding;
    Index shot = 0;
    std::string reason;
    bool operator==(const Acknowledgement &) const = default;
};

/// How a row's deviation and its uncertainty decide on conformity (docs/method/uncertainty.md).
enum class DecisionRule {
    Simple, ///< the deviation is at most the limit
    GuardBand, ///< the deviation is at most the limit less U (ILAC-G8, w = U)
    Risk ///< the probability of being outside is at most a stated one (JCGM 106)
};

/// The claim that a statement of conformity is about: from `from_Hz` to `to_Hz` the magnitude lies
/// within `within_percent` of the sensitivity at low frequency.
struct DecisionSettings
{
    DecisionRule rule = DecisionRule::Simple;
    double within_percent = 5.0;
    double from_Hz = 0.0;
    double to_Hz = 0.0;
    double maxRisk_percent = 5.0; ///< of DecisionRule::Risk
    bool operator==(const DecisionSettings &) const = default;
};

/// Recipe section "certificate": what is printed but not computed. Keys of `fields` are in
/// docs/recipe.md ("laboratory", "laboratory_address", "customer", "sensor_serial", ...).
struct CertificateSettings
{
    std::string templateName = "accredited";
    std::vector<std::string> languages{"en"};
    std::map<std::string, std::string> fields;
    std::optional<DecisionSettings> decision; ///< empty: no statement of conformity
    bool operator==(const CertificateSettings &) const = default;
};

} // namespace dyncal
