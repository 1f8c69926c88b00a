// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"

#include "core/capture/capture_check.h"
#include "core/capture/import_rules.h"
#include "core/pipeline/model_stages.h"
#include "core/pipeline/stage_keys.h"
#include "core/shock/channel_order.h"
#include "core/shock/shock_velocity.h"
#include "core/signal/start_detection.h"

#include <algorithm>
#include <exception>
#include <new>

namespace dyncal {
namespace {

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

/// When the DUTs felt the shock, as far as it can be known before the window is cut.
std::vector<DutArrival> detectedArrivals(const CaptureSet &set, const JobControl &control)
{
    std::vector<DutArrival> arrivals;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Channel *dut = set.shots[i].channelWithRole(ChannelRole::Dut);
        if (!set.shots[i].included || !dut)
            continue;
        if (const auto start = detectStart(*dut, control))
            arrivals.push_back({static_cast<Index>(i) + 1, start->time_s});
    }
    return arrivals;
}

std::vector<std::optional<double>> expectedPlateaus(
    const CaptureSet &set, const std::vector<DutArrival> &arrivals, const ShockSettings &settings)
{
    std::vector<std::optional<double>> plateaus(set.shots.size());
    const auto shock = estimateShockConditions(set, arrivals, settings);
    for (std::size_t i = 0; shock && i < plateaus.size(); ++i) {
        if (const ShockConditions *conditions = shock->ofShot(static_cast<Index>(i) + 1))
            plateaus[i] = conditions->plateau_s;
    }
    return plateaus;
}

Result<WindowResult> window(const CaptureSet &set, const Recipe &recipe, const JobControl &control)
{
    WindowContext context{recipe.input.treatment, recipe.remap, {}, recipe.checks};
    context.plateau_s.resize(set.shots.size());
    Findings order;
    if (recipe.shock.enabled) {
        const std::vector<DutArrival> arrivals = detectedArrivals(set, control);
        context.plateau_s = expectedPlateaus(set, arrivals, recipe.shock);
        if (recipe.shock.dutPosition == kEndWall)
            order = checkChannelOrder(set, arrivals);
    }
    Result<WindowResult> result = cutWindows(set, recipe.window, context, control);
    if (result)
        result->findings.insert(result->findings.begin(), order.begin(), order.end());
    return result;
}

Result<DecompositionResult> decompose(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control)
{
    auto hankel = decomposeHankel(input, settings, control);
    if (!hankel)
        return tl::unexpected(hankel.error());
    OrderSuggestion suggestion = suggestOrder(input, *hankel);
    return DecompositionResult{std::move(*hankel), std::move(suggestion)};
}

/// Runs one stage unless its result is in the cache; keeps count and stops at the first failure.
class Run
{
public:
    Run(PipelineOutcome &outcome, ResultCache &cache, StageId last, const JobControl &control)
        : m_outcome(outcome)
        , m_cache(cache)
        , m_last(last)
        , m_control(control)
    {
    }

    template <typename T, typename Compute>
    Run &stage(StageId id, std::shared_ptr<const T> CalibrationResults::*member, Compute compute)
    {
        if (m_outcome.error || id > m_last)
            return *this;
        const std::string &key = m_outcome.results.keys[static_cast<std::size_t>(id)];
        m_outcome.results.*member = m_cache.find<T>(key);
        if (!(m_outcome.results.*member)) {
            if (m_control.stopRequested())
                return stop(id, Error{ErrorKind::Cancelled, {}, {}, 0});
            Result<T> result = compute();
            if (!result)
                return stop(id, std::move(result.error()));
            m_outcome.results.*member = std::make_shared<const T>(std::move(*result));
            m_cache.store(key, m_outcome.results.*member);
        }
        m_control.report((static_cast<double>(id) + 1.0) / kStageCount);
        return *this;
    }

private:
    Run &stop(StageId id, Error error)
    {
        m_outcome.error = std::move(error);
        m_outcome.failedStage = id;
        return *this;
    }

    PipelineOutcome &m_outcome;
    ResultCache &m_cache;
    StageId m_last;
    const JobControl &m_control;
};

/// The method (thesis 3.7), one call per step.
void runStages(const CaptureSet &captures, const Recipe &recipe, Run &run, CalibrationResults &r,
    const JobControl &control)
{
    using R = CalibrationResults;
    run.stage(StageId::Captures, &R::captures, [&] { return prepareCaptures(captures, recipe); })
        .stage(
            StageId::Window, &R::window, [&] { return window(r.captures->set, recipe, control); })
        .stage(StageId::Spectrum, &R::spectrum,
            [&] { return analyseSpectra(r.window->responses, recipe.spectrum, control); })
        .stage(StageId::Components, &R::components,
            [&] {
                return analyseComponents(r.window->responses, recipe.pca, recipe.spectrum, control);
            })
        .stage(StageId::ModelInput, &R::input,
            [&] {
                return prepareModelInput(
                    r.window->responses, *r.spectrum, *r.components, recipe.input, control);
            })
        .stage(StageId::Decomposition, &R::decomposition,
            [&] { return decompose(*r.input, recipe.realization, control); })
        .stage(StageId::Model, &R::model,
            [&] { return modelStage(r, recipe, orderOf(r, recipe), control); })
        .stage(
            StageId::Shock, &R::shock, [&] { return shockOfModel(r, recipe, *r.model, control); })
        .stage(StageId::Response, &R::response,
            [&] { return responseStage(r, recipe, *r.model, *r.shock); })
        .stage(StageId::Evidence, &R::evidence, [&] {
            return gatherOrderEvidence(*r.input, r.decomposition->hankel,
                r.decomposition->suggestion, recipe.realization, control);
        });
}

Error outOfMemory()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "Not enough memory for this calibration; shorten the window or the model input."),
            {}},
        {}, 0};
}

/// Whether one of the first `count` findings says of the same channel what `finding` says again.
bool isTold(const Findings &findings, std::size_t count, const Finding &finding)
{
    return !finding.channel.empty()
        && std::any_of(findings.begin(), findings.begin() + static_cast<std::ptrdiff_t>(count),
            [&](const Finding &told) {
                return told.id == finding.id && told.shot == finding.shot
                    && told.channel == finding.channel && told.severity >= finding.severity;
            });
}

} // namespace

const char *stageName(StageId stage)
{
    switch (stage) {
    case StageId::Captures:
        return "captures";
    case StageId::Window:
        return "window";
    case StageId::Spectrum:
        return "spectrum";
    case StageId::Components:
        return "components";
    case StageId::ModelInput:
        return "model input";
    case StageId::Decomposition:
        return "decomposition";
    case StageId::Model:
        return "model";
    case StageId::Shock:
        return "shock";
    case StageId::Response:
        return "response";
    case StageId::Evidence:
        return "evidence";
    }
    return "";
}

Findings CalibrationResults::findings() const
{
    Findings all;
    const auto add = [&all](const auto &result) {
        const std::size_t earlier = all.size();
        for (const Finding &finding : result ? result->findings : Findings()) {
            if (!isTold(all, earlier, finding))
                all.push_back(finding);
        }
    };
    add(captures);
    add(window);
    add(spectrum);
    add(components);
    add(input);
    add(model);
    add(shock);
    add(response);
    add(evidence);
    return all;
}

PipelineOutcome runPipeline(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
    ResultCache &cache, StageId last, const JobControl &control)
{
    PipelineOutcome outcome;
    try {
        outcome.results.keys = stageKeys(*captures, recipe);
        Run run(outcome, cache, last, control);
        runStages(*captures, recipe, run, outcome.results, control);
    } catch (const std::bad_alloc &) {
        outcome.error = outOfMemory();
    } catch (const std::exception &exception) {
        outcome.error = Error{ErrorKind::Internal,
            {DYNCAL_TEXT("core", "Internal error: %1. Please report it with the recipe."),
                {exception.what()}},
            {}, 0};
    }
    return outcome;
}

} // namespace dyncal
