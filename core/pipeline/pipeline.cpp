// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"

#include "core/pipeline/stage_keys.h"
#include "core/pipeline/stage_table.h"

#include <exception>
#include <new>

namespace dyncal {
namespace {

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

    /// All stages up to the last; what has failed before is not tried.
    void all(const CaptureSet &captures, const Recipe &recipe)
    {
        for (int i = 0; i <= static_cast<int>(m_last) && !m_outcome.error; ++i)
            one(stageOf(static_cast<StageId>(i)), captures, recipe);
        // What fails gives the same whether or not an earlier run got further.
        if (!m_outcome.error || m_outcome.error->kind == ErrorKind::Cancelled)
            remember(stageOf(StageId::Assessment));
    }

private:
    using Any = StageResult::Any;

    void one(const Stage &stage, const CaptureSet &captures, const Recipe &recipe)
    {
        Result<Any> found = m_cache.find<void>(keyOf(stage));
        if (!*found)
            found = computed(stage, captures, recipe);
        if (!found) {
            m_outcome.error = std::move(found.error());
            m_outcome.failedStage = stage.id;
            return;
        }
        stage.result.put(m_outcome.results, *found);
        reach(progressAfter(stage.id, m_last));
    }

    Result<Any> computed(const Stage &stage, const CaptureSet &captures, const Recipe &recipe)
    {
        const Error cancelled{ErrorKind::Cancelled, {}, {}, 0};
        if (m_control.stopRequested())
            return tl::unexpected(cancelled);
        const JobControl control = controlOf(stage.id);
        Result<Any> result = stage.result.compute({captures, recipe, m_outcome.results, control});
        if (!result)
            return result;
        if (m_control.stopRequested()) // the result may be incomplete
            return tl::unexpected(cancelled);
        m_cache.store<void>(keyOf(stage), *result);
        return result;
    }

    /// Takes a later stage's result from the cache if all it follows from is there: this run may
    /// have ended before that stage.
    void remember(const Stage &stage)
    {
        if (hasResult(m_outcome.results, stage.follows) && !hasResult(m_outcome.results, stage.id))
            stage.result.put(m_outcome.results, m_cache.find<void>(keyOf(stage)));
    }

    const std::string &keyOf(const Stage &stage) const
    {
        return m_outcome.results.keys[static_cast<std::size_t>(stage.id)];
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
        Run(outcome, cache, last, control).all(*captures, recipe);
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
