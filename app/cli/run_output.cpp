// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/run_output.h"

#include "app/base/interrupt.h"
#include "app/cli/drawing_process.h"
#include "core/results/publication.h"

namespace dyncal {

Result<std::vector<std::string>> writeRun(const PipelineOutcome &outcome, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen, FolderWrite &folder,
    const std::string &record)
{
    RunFiles run{outcome, recipe, createdUtc, {}, record, chosen};
    if (mayPublish(outcome)) {
        Result<std::vector<DrawnFile>> drawn
            = drawWithoutWindow(outcome.results, recipe, createdUtc, chosen);
        if (!drawn)
            return tl::unexpected<Error>(drawn.error());
        run.drawn = std::move(*drawn);
    }
    return writeRunFiles(run, folder, {interruptToken(), {}});
}

} // namespace dyncal
