// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/early_stages.h"

#include "core/capture/capture_check.h"
#include "core/capture/import_rules.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/second_order/second_order_choice.h"
#include "core/signal/window_cutting.h"

namespace dyncal {

Result<PreparedCaptures> prepareCaptures(const CaptureSet &captures, const Recipe &recipe)
{
    auto set = applyImportSettings(captures, recipe.import, recipe.checks);
    if (!set)
        return tl::unexpected(set.error());
    PreparedCaptures prepared{std::move(*set), {}};
    prepared.findings = prepared.set.findings;
    const Findings checked = checkCaptures(prepared.set, recipe.checks);
    prepared.findings.insert(prepared.findings.end(), checked.begin(), checked.end());
    return prepared;
}

Result<WindowResult> windowStage(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control)
{
    const CaptureSet &set = results.captures->set;
    WindowContext context{recipe.input.treatment, recipe.remap, {}, recipe.checks, {}};
    for (Index shot = 1; shot <= std::ssize(set.shots); ++shot) {
        const ShockConditions *conditions = results.expected->conditions.ofShot(shot);
        context.plateau_s.push_back(conditions ? conditions->plateau_s : std::nullopt);
        const Channel *dut
            = set.shots[static_cast<std::size_t>(shot - 1)].channelWithRole(ChannelRole::Dut);
        const DetectedStart *start = results.starts->of(set, shot, dut);
        context.starts.push_back(start ? std::optional(*start) : std::nullopt);
    }
    Result<WindowResult> result = cutWindows(set, recipe.window, context, control);
    if (result)
        result->findings.insert(result->findings.begin(), results.expected->findings.begin(),
            results.expected->findings.end());
    return result;
}

Result<DecompositionResult> decompositionStage(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control)
{
    const ModelInput sensor = sensorOnly(input);
    auto hankel = decomposeHankel(sensor, settings, control.part(0, 2));
    if (!hankel)
        return tl::unexpected(hankel.error());
    OrderSuggestion suggestion = suggestOrder(sensor, *hankel, control.part(1, 2));
    considerSecondOrder(input, *hankel, suggestion, control);
    return DecompositionResult{std::move(*hankel), std::move(suggestion)};
}

} // namespace dyncal
