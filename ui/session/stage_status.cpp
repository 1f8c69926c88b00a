// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/stage_status.h"

#include "core/pipeline/stage_keys.h"

#include <array>

namespace dyncal {

bool hasResult(const CalibrationResults &results, StageId stage)
{
    switch (stage) {
    case StageId::Captures:
        return results.captures != nullptr;
    case StageId::Arrivals:
        return results.starts != nullptr;
    case StageId::Expected:
        return results.expected != nullptr;
    case StageId::Window:
        return results.window != nullptr;
    case StageId::Spectrum:
        return results.spectrum != nullptr;
    case StageId::Components:
        return results.components != nullptr;
    case StageId::ModelInput:
        return results.input != nullptr;
    case StageId::Decomposition:
        return results.decomposition != nullptr;
    case StageId::Model:
        return results.model != nullptr;
    case StageId::Shock:
        return results.shock != nullptr;
    case StageId::Response:
        return results.response != nullptr;
    case StageId::Assessment:
        return results.model && results.model->isAssessed;
    case StageId::Evidence:
        return results.evidence != nullptr;
    case StageId::MonteCarlo:
        return results.monteCarlo != nullptr;
    }
    return false;
}

Findings findingsOf(const CalibrationResults &results, StageId stage)
{
    if (!hasResult(results, stage))
        return {};
    switch (stage) {
    case StageId::Captures:
        return results.captures->findings;
    case StageId::Arrivals:
    case StageId::Expected:
        return {}; // said by the stages that use them
    case StageId::Window:
        return results.window->findings;
    case StageId::Spectrum:
        return results.spectrum->findings;
    case StageId::Components:
        return results.components->findings;
    case StageId::ModelInput:
        return results.input->findings;
    case StageId::Decomposition:
        return {};
    case StageId::Model:
        return results.model->findings;
    case StageId::Shock:
        return results.shock->findings;
    case StageId::Response:
        return results.response->findings;
    case StageId::Assessment:
        return {}; // among the model's
    case StageId::Evidence:
        return results.evidenceFindings();
    case StageId::MonteCarlo:
        return results.monteCarlo->findings;
    }
    return {};
}

StageStatus stageStatus(const RunState &run, StageId stage)
{
    const int position = static_cast<int>(stage);
    const bool stale = position >= run.firstStale;
    if (run.computing && stale)
        return hasResult(run.results, stage) ? StageStatus::Stale : StageStatus::Computing;
    if (run.error && position >= static_cast<int>(run.failedStage))
        return StageStatus::Blocked;
    if (!hasResult(run.results, stage))
        return StageStatus::NotStarted;
    if (stale)
        return StageStatus::Stale;
    switch (worstSeverity(findingsOf(run.results, stage))) {
    case Severity::Block:
        return StageStatus::Blocked;
    case Severity::Caution:
        return StageStatus::DoneWithCautions;
    case Severity::Info:
        break;
    }
    return StageStatus::Done;
}

std::optional<StageId> stageOfFinding(const std::string &id)
{
    static const std::array<std::pair<const char *, StageId>, 9> kPrefixes{{
        {"CAP-", StageId::Captures},
        {"SHK-", StageId::Shock},
        {"WIN-", StageId::Window},
        {"SPC-", StageId::Spectrum},
        {"PCA-", StageId::Components},
        {"MIN-", StageId::ModelInput},
        {"ORD-", StageId::Decomposition},
        {"MOD-", StageId::Model},
        {"RSP-", StageId::Response},
    }};
    for (const auto &[prefix, stage] : kPrefixes)
        if (id.starts_with(prefix))
            return stage;
    return std::nullopt;
}

std::optional<StageId> firstAffectedStage(const Recipe &before, const Recipe &after)
{
    const CaptureSet same; // the recordings do not change with the recipe
    const auto keysBefore = stageKeys(same, before);
    const auto keysAfter = stageKeys(same, after);
    for (std::size_t stage = 0; stage < keysBefore.size(); ++stage)
        if (keysBefore[stage] != keysAfter[stage])
            return static_cast<StageId>(stage);
    return std::nullopt;
}

} // namespace dyncal
