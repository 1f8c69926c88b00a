// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

namespace dyncal {

/// Why only results.json and the recipe may leave the program: the error that stopped the run or,
/// if it came to its end, the first finding that blocks, as an error of kind DataBlocked. Empty:
/// model, tables, plots and certificate may be written. All subcommands and the window use this
/// rule. An acknowledgement accepts a caution but never lifts a block.
std::optional<Error> publicationObstacle(const PipelineOutcome &outcome);

inline bool mayPublish(const PipelineOutcome &outcome)
{
    return !publicationObstacle(outcome);
}

} // namespace dyncal
