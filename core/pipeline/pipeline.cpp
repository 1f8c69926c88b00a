// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"

#include "core/capture/capture_check.h"
#include "core/capture/import_rules.h"
#include "core/decomposition/component_analysis.h"
#include "core/pipeline/model_stages.h"
#include "core/pipeline/nuisance_stage.h"
#include "core/pipeline/stage_keys.h"
#include "core/pipeline/stage_table.h"
#include "core/realization/hankel/order_suggestion.h"
#include "core/realization/model/model_assessing.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/order/order_scan.h"
#include "core/shock/shock_velocity.h"
#include "core/shock/step_monte_carlo.h"
#include "core/signal/window_cutting.h"

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

Result<WindowResult> window(
    const CalibrationResults &r, const Recipe &recipe, const JobControl &control)
{
    const CaptureSet &set = r.captures->set;
    WindowContext context{recipe.input.treatment, recipe.remap, {}, recipe.checks, {}};
    for (Index shot = 1; shot <= std::ssize(set.shots); ++shot) {
        const ShockConditions *conditions = r.expected->conditions.ofShot(shot);
        context.plateau_s.push_back(conditions ? conditions->plateau_s : std::nullopt);
        const Channel *dut
            = set.shots[static_cast<std::size_t>(shot - 1)].channelWithRole(ChannelRole::Dut);
        const DetectedStart *start = r.starts->of(set, shot, dut);
        context.starts.push_back(start ? std::optional(*start) : std::nullopt);
    }
    Result<WindowResult> result = cutWindows(set, recipe.window, context, control);
    if (result)
        result->findings.insert(
            result->findings.begin(), r.expected->findings.begin(), r.expected->findings.end());
    return result;
}

Result<DecompositionResult> decompose(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control)
{
    auto hankel = decomposeHankel(input, settings, control.part(0, 2));
    if (!hankel)
        return tl::unexpected(hankel.error());
    OrderSuggestion suggestion = suggestOrder(input, *hankel, control.part(1, 2));
    return DecompositionResult{std::move(*hankel), std::move(suggestion)};
}

/// Runs each stage unless its result is in the cache, reports progress and stops at the first
/// failure.
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
        std::shared_ptr<const T> found = m_cache.find<T>(key);
        if (!found) {
            if (m_control.stopRequested())
                return stop(id, Error{ErrorKind::Cancelled, {}, {}, 0});
            Result<T> result = compute(controlOf(id));
            if (!result)
                return stop(id, std::move(result.error()));
            if (m_control.stopRequested()) // the result may be incomplete
                return stop(id, Error{ErrorKind::Cancelled, {}, {}, 0});
            found = std::make_shared<const T>(std::move(*result));
            m_cache.store(key, found);
        }
        m_outcome.results.*member = std::move(found);
        reach(progressAfter(id, m_last));
        return *this;
    }

    /// Takes a later stage's result from the cache if all it follows from is there: this run may
    /// end before that stage.
    template <typename T>
    Run &remembered(StageId id, std::shared_ptr<const T> CalibrationResults::*member)
    {
        if (hasResult(m_outcome.results, stageOf(id).follows))
            m_outcome.results.*member
                = m_cache.find<T>(m_outcome.results.keys[static_cast<std::size_t>(id)]);
        return *this;
    }

private:
    Run &stop(StageId id, Error error)
    {
        m_outcome.error = std::move(error);
        m_outcome.failedStage = id;
        return *this;
    }

    /// Maps a stage's progress 0..1 to its part of the run.
    JobControl controlOf(StageId id)
    {
        const double begin = m_reached;
        const double end = progressAfter(id, m_last);
        return {m_control.stop,
            [this, begin, end](double fraction) { reach(begin + fraction * (end - begin)); }};
    }

    /// Progress never falls, although a stage may try several things, each from 0 to 1.
    void reach(double fraction)
    {
        if (fraction > m_reached)
            m_control.report(m_reached = fraction);
    }

    PipelineOutcome &m_outcome;
    ResultCache &m_cache;
    StageId m_last;
    const JobControl &m_control;
    double m_reached = 0.0;
};

/// The method (thesis 3.7), one call per step.
void runStages(const CaptureSet &captures, const Recipe &recipe, Run &run, CalibrationResults &r)
{
    using R = CalibrationResults;
    using Control = const JobControl &;
    run.stage(StageId::Captures, &R::captures,
           [&](Control) { return prepareCaptures(captures, recipe); })
        .stage(StageId::Arrivals, &R::starts,
            [&](Control control) {
                return detectStarts(r.captures->set, arrivalChannels(recipe.shock), control,
                    recipe.checks.stepSigmas);
            })
        .stage(StageId::Expected, &R::expected,
            [&](Control) { return expectedShock(r.captures->set, *r.starts, recipe); })
        .stage(StageId::Window, &R::window,
            [&](Control control) { return window(r, recipe, control); })
        .stage(StageId::Spectrum, &R::spectrum,
            [&](Control control) {
                return analyseSpectra(r.window->responses, recipe.spectrum, control);
            })
        .stage(StageId::Components, &R::components,
            [&](Control control) {
                return analyseComponents(r.window->responses, recipe.pca, recipe.spectrum, control);
            })
        .stage(StageId::ModelInput, &R::input,
            [&](Control control) { return separatedInput(r, recipe, control); })
        .stage(StageId::Decomposition, &R::decomposition,
            [&](Control control) {
                return decompose(sensorOnly(*r.input), recipe.realization, control);
            })
        .stage(StageId::Model, &R::model,
            [&](Control control) { return modelStage(r, recipe, orderOf(r, recipe), control); })
        .remembered(StageId::Assessment, &R::assessment)
        .stage(
            StageId::Shock, &R::shock, [&](Control) { return shockOfModel(r, recipe, *r.model); })
        .stage(StageId::Response, &R::response,
            [&](Control) { return responseStage(r, recipe, *r.model, *r.shock); })
        .stage(StageId::Assessment, &R::assessment,
            [&](Control control) {
                return assessModel(*r.input, *r.model, recipe.realization, control);
            })
        .stage(StageId::Evidence, &R::evidence,
            [&](Control control) {
                return gatherOrderEvidence(sensorOnly(*r.input), r.decomposition->hankel,
                    r.decomposition->suggestion, recipe.realization, control);
            })
        .stage(StageId::MonteCarlo, &R::monteCarlo,
            [&](Control control) { return stepMonteCarlo(*r.shock, recipe.uncertainty, control); });
}

Error outOfMemory()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "Not enough memory for this calibration; shorten the window or the model input."),
            {}},
        {}, 0};
}

} // namespace

PipelineOutcome runPipeline(const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe,
    ResultCache &cache, StageId last, const JobControl &control)
{
    PipelineOutcome outcome;
    try {
        outcome.results.keys = stageKeys(*captures, recipe);
        Run run(outcome, cache, last, control);
        runStages(*captures, recipe, run, outcome.results);
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
