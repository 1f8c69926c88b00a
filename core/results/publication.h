// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

namespace dyncal {

/// Why nothing but results.json and the recipe may leave the program: the error that stopped the
/// run or, of a run that came to its end, the first finding that blocks, as an error of kind
/// DataBlocked. Empty: model, tables, plots and certificate may be written. The one rule of every
/// verb and of the window. An acknowledgement accepts a caution and never lifts a block.
std::optional<Error> publicationObstacle(const PipelineOutcome &outcome);

inline bool mayPublish(const PipelineOutcome &outcome)
{
    return !publicationObstacle(outcome);
}

} // namespace dyncal
