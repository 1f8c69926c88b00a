// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/method_versions.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A step of the method whose version is not the one of the earlier results.
struct MethodChange
{
    std::string step; ///< as in `software.method` of results.json
    std::optional<int> issued; ///< empty: there was no such step, or no versions were recorded
    std::optional<int> now; ///< empty: there is no such step any more

    bool isOfLaterVersion() const { return issued && (!now || *issued > *now); }
    std::string text() const; ///< "shock 1 -> 6", "uncertainty 3 (new)"
    bool operator==(const MethodChange &) const = default;
};

/// The method versions that a results.json states; empty where it is from before they were.
std::optional<MethodVersions> statedMethods(const nlohmann::json &results);

/// The steps that changed, by name. Without recorded versions: those whose version is above 1, as
/// their first one.
std::vector<MethodChange> methodChanges(
    const std::optional<MethodVersions> &issued, const MethodVersions &now);

} // namespace dyncal
