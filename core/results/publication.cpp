// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/publication.h"
#include "core/pipeline/stage_table.h"

#include <algorithm>

namespace dyncal {

std::optional<Error> publicationObstacle(const PipelineOutcome &outcome)
{
    if (outcome.error)
        return outcome.error;
    const Findings findings = allFindings(outcome.results);
    const auto block = std::ranges::find(findings, Severity::Block, &Finding::severity);
    if (block == findings.end())
        return std::nullopt;
    return Error{ErrorKind::DataBlocked, block->message, block->id, block->shot};
}

} // namespace dyncal
