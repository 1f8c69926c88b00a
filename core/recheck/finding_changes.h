// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace dyncal {

/// A finding as a results.json has it.
struct StatedFinding
{
    std::string id;
    std::string severity; ///< "info", "caution" or "block"
    Index shot = 0; ///< from 1; 0 = concerns no single shot
    std::string message;

    /// "CHK-002 (caution, shot 1): ..."
    std::string text() const;
};

struct FindingChanges
{
    std::vector<StatedFinding> appeared; ///< in the order of the results
    std::vector<StatedFinding> gone;
};

/// How far a run was computed again.
enum class RecheckDepth {
    ToEvidence, ///< without the Monte Carlos, of which only findings are compared
    Whole,
};

/// Findings are the same where id, severity and shot are. CAP-024 is of the folder that was given
/// then and not of its recordings, so that it says nothing here; where `now` was computed to the
/// evidence only, nor do those that a Monte Carlo raises (SHK-012, UNC-003).
FindingChanges findingChanges(const nlohmann::json &issued, const nlohmann::json &now,
    RecheckDepth depth = RecheckDepth::Whole);

/// Why the run of these results allowed none to be issued: the error that stopped it, else its
/// first finding that blocks. Empty: nothing blocks.
std::string blockOf(const nlohmann::json &results);

} // namespace dyncal
