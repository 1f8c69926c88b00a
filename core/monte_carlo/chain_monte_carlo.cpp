// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/chain_monte_carlo.h"

#include "core/base/input_draws.h"
#include "core/monte_carlo/chain_findings.h"
#include "core/monte_carlo/stable_trials.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace dyncal {
namespace {

constexpr Index kBatch = 10000; ///< JCGM 101, 7.9.4: of 95 % and two digits
constexpr Index kMostAdaptive = 200000;
constexpr Index kReported = 500; ///< trials from one report of progress to the next
constexpr double kShareOfTrials = 0.85; ///< of the time; the rest is of the rows

/// How many values and rows both propagations may have.
Index comparisonsOf(const TrialPlan &plan)
{
    const ResponseResult &response = plan.subject.response;
    const Index marked = response.atMarks ? response.atMarks->magnitude.size() : 0;
    return std::max<Index>(
        1, std::ssize(plan.quantities) + 2 * (response.magnitude.size() + marked));
}

/// Values of one block, as the batches of an adaptive run are compared.
std::vector<DrawnQuantity> quantitiesOf(
    const TrialPlan &plan, const TrialBlock &block, double coverage)
{
    std::vector<DrawnQuantity> list;
    for (Index i = 0; i < block.values.cols(); ++i) {
        const ReportedValue &reported = plan.quantities[static_cast<std::size_t>(i)].reported;
        list.push_back(
            drawnQuantity(block.values.col(i), reported.value, coverage, comparisonsOf(plan)));
        leaveOutMoments(leastDofOf(reported.lines), list.back());
    }
    return list;
}

Result<TrialBlock> trialsWithProgress(
    const TrialPlan &plan, Index begin, Index count, const JobControl &control)
{
    std::vector<TrialBlock> blocks;
    for (Index done = 0; done < count; done += kReported) {
        auto block = runTrials(plan, begin + done, std::min(kReported, count - done), control);
        if (!block)
            return block;
        blocks.push_back(std::move(*block));
        control.report(static_cast<double>(done) / static_cast<double>(count));
    }
    return mergedBlocks(blocks);
}

struct AllTrials
{
    TrialBlock block;
    bool isStable = false;
};

Result<AllTrials> adaptiveTrials(const TrialPlan &plan, double coverage, const JobControl &control)
{
    constexpr int kDigits = 2;
    std::vector<TrialBlock> blocks;
    std::vector<std::vector<DrawnQuantity>> batches;
    bool isStable = false;
    for (Index done = 0; done < kMostAdaptive && !isStable; done += kBatch) {
        const JobControl part
            = control.part(static_cast<std::size_t>(done / kBatch), kMostAdaptive / kBatch);
        auto block = trialsWithProgress(plan, done, kBatch, part);
        if (!block)
            return tl::unexpected(block.error());
        batches.push_back(quantitiesOf(plan, *block, coverage));
        blocks.push_back(std::move(*block));
        isStable = areStable(batches, kDigits);
    }
    return mergedBlocks(blocks).map([=](TrialBlock all) {
        return AllTrials{std::move(all), isStable};
    });
}

Result<AllTrials> allTrials(
    const TrialPlan &plan, const UncertaintySettings &settings, const JobControl &control)
{
    if (settings.monteCarloTrials == 0)
        return adaptiveTrials(plan, settings.coverage, control);
    return trialsWithProgress(plan, 0, settings.monteCarloTrials, control).map([](TrialBlock all) {
        return AllTrials{std::move(all), false};
    });
}

void addValues(const TrialPlan &plan, const TrialBlock &trials, ChainMonteCarlo &result)
{
    const auto drawn = quantitiesOf(plan, trials, result.coverage);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const ReportedValue &reported = plan.quantities[i].reported;
        result.values.push_back({plan.quantities[i].of, reported.unit, reported.value, drawn[i],
            validateGum(reported, result.coverage, drawn[i])});
    }
}

Result<void> addRows(const TrialPlan &plan, const TrialBlock &trials, const JobControl &control,
    ChainMonteCarlo &result)
{
    const ResponseResult &response = plan.subject.response;
    const UncertaintyReport &report = plan.subject.report;
    const DrawnIntervals intervals{result.coverage, comparisonsOf(plan)};
    auto rows = drawnRows(plan, trials, response, report.rows, intervals, control);
    if (!rows)
        return tl::unexpected(rows.error());
    result.rows = std::move(*rows);
    if (!response.atMarks)
        return {};
    auto marked
        = drawnRows(plan, trials, *response.atMarks, report.rowsAtMarks, intervals, control);
    if (!marked)
        return tl::unexpected(marked.error());
    result.rowsAtMarks = std::move(*marked);
    return {};
}

bool hasNothing(const TrialPlan &plan)
{
    return plan.quantities.empty() && plan.subject.response.magnitude.size() == 0;
}

/// Every U is stated at 95 %: intervals of another coverage say nothing of it.
bool isOfStatedCoverage(double coverage)
{
    constexpr double kStated = 0.95;
    return std::abs(coverage - kStated) < 1e-9;
}

} // namespace

ValidatedCount ChainMonteCarlo::count() const
{
    ValidatedCount all;
    const auto add = [&](bool isThere, const GumValidation &gum) {
        all.compared += isThere ? 1 : 0;
        all.validated += isThere && gum.validated ? 1 : 0;
    };
    for (const DrawnValue &one : values)
        add(true, one.gum);
    for (const auto *list : {&rows, &rowsAtMarks}) {
        for (const DrawnRow &row : *list) {
            add(row.withMagnitude, row.gumMagnitude);
            add(row.withPhase, row.gumPhase);
        }
    }
    return all;
}

bool ChainMonteCarlo::isValidated() const
{
    const ValidatedCount all = count();
    return all.compared > 0 && all.validated == all.compared;
}

const DrawnValue *ChainMonteCarlo::find(const std::string &of) const
{
    const auto found = std::ranges::find(values, of, &DrawnValue::of);
    return found == values.end() ? nullptr : &*found;
}

Result<ChainMonteCarlo> chainMonteCarlo(const ChainSubject &subject,
    const UncertaintySettings &settings, const FitAgain &fitAgain, const JobControl &control)
{
    const auto seed = static_cast<std::uint64_t>(settings.seed);
    if (auto checked = checkMonteCarlo({settings.monteCarloTrials, seed, 0, settings.coverage});
        !checked)
        return tl::unexpected(checked.error());
    ChainMonteCarlo result;
    result.seed = settings.seed;
    result.coverage = settings.coverage;
    result.isAdaptive = settings.monteCarloTrials == 0;
    const TrialPlan plan = trialPlan(subject, seed);
    if (hasNothing(plan))
        return result;
    const JobControl first = control.between(0.0, kShareOfTrials);
    const auto trials = allTrials(plan, settings, first);
    if (!trials)
        return tl::unexpected(trials.error());
    result.trials = trials->block.count();
    result.isStable = trials->isStable;
    addValues(plan, trials->block, result);
    if (auto rows = addRows(plan, trials->block, control, result); !rows)
        return tl::unexpected(rows.error());
    if (result.count().compared == 0) { // no value has a u, nor a row
        result.trials = 0;
        return result;
    }
    auto refits = fullRefits(subject, plan.inputs, fitAgain, result.trials, seed, control);
    if (!refits)
        return tl::unexpected(refits.error());
    result.refits = std::move(*refits);
    if (isOfStatedCoverage(result.coverage))
        result.findings = judgeChain(result.values, result.rows, result.rowsAtMarks);
    std::ranges::move(judgeRefits(result.refits), std::back_inserter(result.findings));
    return result;
}

} // namespace dyncal
