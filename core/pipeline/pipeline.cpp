// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"

#include "core/capture/capture_check.h"
#include "core/capture/import_rules.h"
#include "core/pipeline/model_stages.h"
#include "core/pipeline/nuisance_stage.h"
#include "core/pipeline/stage_keys.h"
#include "core/realization/model_assessment.h"
#include "core/realization/model_findings.h"
#include "core/realization/nuisance_modes.h"
#include "core/shock/shock_velocity.h"

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
    auto hankel = decomposeHankel(input, settings, control);
    if (!hankel)
        return tl::unexpected(hankel.error());
    OrderSuggestion suggestion = suggestOrder(input, *hankel, control);
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
        std::shared_ptr<const T> found = m_cache.find<T>(key);
        if (!found) {
            if (m_control.stopRequested())
                return stop(id, Error{ErrorKind::Cancelled, {}, {}, 0});
            Result<T> result = compute();
            if (!result)
                return stop(id, std::move(result.error()));
            if (m_control.stopRequested()) // what it gave may be half of a result
                return stop(id, Error{ErrorKind::Cancelled, {}, {}, 0});
            found = std::make_shared<const T>(std::move(*result));
            m_cache.store(key, found);
        }
        m_outcome.results.*member = std::move(found);
        m_control.report((static_cast<double>(id) + 1.0) / kStageCount);
        return *this;
    }

    /// A later stage's result, which completes that of an earlier one, where it is known already.
    template <typename T>
    Run &completed(StageId id, std::shared_ptr<const T> CalibrationResults::*member)
    {
        if (!(m_outcome.results.*member))
            return *this;
        if (auto found = m_cache.find<T>(m_outcome.results.keys[static_cast<std::size_t>(id)]))
            m_outcome.results.*member = std::move(found);
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
        .stage(StageId::Arrivals, &R::starts,
            [&] {
                return detectStarts(r.captures->set, arrivalChannels(recipe.shock), control,
                    recipe.checks.stepSigmas);
            })
        .stage(StageId::Expected, &R::expected,
            [&] { return expectedShock(r.captures->set, *r.starts, recipe); })
        .stage(StageId::Window, &R::window, [&] { return window(r, recipe, control); })
        .stage(StageId::Spectrum, &R::spectrum,
            [&] { return analyseSpectra(r.window->responses, recipe.spectrum, control); })
        .stage(StageId::Components, &R::components,
            [&] {
                return analyseComponents(r.window->responses, recipe.pca, recipe.spectrum, control);
            })
        .stage(StageId::ModelInput, &R::input, [&] { return separatedInput(r, recipe, control); })
        .stage(StageId::Decomposition, &R::decomposition,
            [&] { return decompose(sensorOnly(*r.input), recipe.realization, control); })
        .stage(StageId::Model, &R::model,
            [&] { return modelStage(r, recipe, orderOf(r, recipe), control); })
        .completed(StageId::Assessment, &R::model)
        .stage(StageId::Shock, &R::shock, [&] { return shockOfModel(r, recipe, *r.model); })
        .stage(StageId::Response, &R::response,
            [&] { return responseStage(r, recipe, *r.model, *r.shock); })
        .stage(StageId::Assessment, &R::model, // the same model, complete
            [&] { return assessModel(*r.input, *r.model, recipe.realization, control); })
        .stage(StageId::Evidence, &R::evidence,
            [&] {
                return gatherOrderEvidence(sensorOnly(*r.input), r.decomposition->hankel,
                    r.decomposition->suggestion, recipe.realization, control);
            })
        .stage(StageId::MonteCarlo, &R::monteCarlo,
            [&] { return stepMonteCarlo(*r.shock, recipe.uncertainty, control); });
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
    case StageId::Arrivals:
        return "arrivals";
    case StageId::Expected:
        return "expected shock";
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
    case StageId::Assessment:
        return "model assessment";
    case StageId::Evidence:
        return "evidence";
    case StageId::MonteCarlo:
        return "Monte Carlo";
    }
    return "";
}

Findings CalibrationResults::findings() const
{
    Findings all;
    const auto append = [&all](const Findings &findings) {
        const std::size_t earlier = all.size();
        for (const Finding &finding : findings) {
            if (!isTold(all, earlier, finding))
                all.push_back(finding);
        }
    };
    const auto add
        = [&append](const auto &result) { append(result ? result->findings : Findings()); };
    add(captures);
    add(window);
    add(spectrum);
    add(components);
    add(input);
    add(model);
    add(shock);
    add(response);
    append(evidenceFindings());
    add(monteCarlo);
    return all;
}

Findings CalibrationResults::evidenceFindings() const
{
    if (!evidence)
        return {};
    Findings findings = evidence->findings;
    if (model) {
        const Findings ofModel = judgeOtherShots(*model, *evidence);
        findings.insert(findings.end(), ofModel.begin(), ofModel.end());
    }
    return findings;
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
