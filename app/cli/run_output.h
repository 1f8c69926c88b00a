// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/run_files.h"

namespace dyncal {

/// Draws what `dyncal run` promises and writes it all (writeRunFiles). Certificate and plots only
/// if the results may be published. For a program without a window (drawWithoutWindow). `record`:
/// as RunFiles::record. `chosen`: what the certificate shows.
Result<std::vector<std::string>> writeRun(const PipelineOutcome &outcome, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen, FolderWrite &folder,
    const std::string &record = {});

} // namespace dyncal
