// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_context.h"

#include <algorithm>

namespace dyncal {

std::string ResultsContext::whyMissing() const
{
    if (!outcome.error)
        return "Not computed: the run was not asked to go this far.";
    return "Not computed, because the run stopped before: " + english(outcome.error->message);
}

const WindowedResponse *ResultsContext::responseOf(Index shot) const
{
    if (!results().window)
        return nullptr;
    const auto &responses = results().window->responses;
    const auto found = std::find_if(responses.begin(), responses.end(),
        [shot](const WindowedResponse &response) { return response.shot == shot; });
    return found != responses.end() ? &*found : nullptr;
}

const SeriesFit *ResultsContext::fitOf(Index shot) const
{
    if (!results().model)
        return nullptr;
    const auto &series = results().model->series;
    const auto found = std::find_if(
        series.begin(), series.end(), [shot](const SeriesFit &fit) { return fit.shot == shot; });
    return found != series.end() ? &*found : nullptr;
}

} // namespace dyncal
