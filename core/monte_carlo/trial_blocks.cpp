// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/trial_blocks.h"

#include "core/base/parallel.h"
#include "core/monte_carlo/model_draws.h"
#include "core/monte_carlo/sensitivity_draws.h"

#include <algorithm>
#include <atomic>
#include <optional>

namespace dyncal {
namespace {

constexpr Index kPart = 50; ///< trials that one thread makes in a row

void addQuantity(TrialQuantity quantity, TrialPlan &plan)
{
    if (quantity.reported.u && *quantity.reported.u > 0.0)
        plan.quantities.push_back(std::move(quantity));
}

std::string numbered(const char *list, std::size_t i, const char *of)
{
    return std::string(list) + "[" + std::to_string(i) + "]" + of;
}

void addSensitivities(TrialPlan &plan)
{
    const UncertaintyReport &report = plan.subject.report;
    if (plan.inputs.means.empty() || !report.sensitivity)
        return;
    addQuantity({"sensitivity", *report.sensitivity, 0}, plan);
    for (std::size_t i = 0; i < report.perLevel.size(); ++i)
        addQuantity({numbered("sensitivity.per_level", i, ""), report.perLevel[i],
                        static_cast<Index>(i) + 1},
            plan);
    for (std::size_t i = 0; i < report.ofShots.size(); ++i)
        addQuantity(
            {numbered("shots", i, ".sensitivity"), report.ofShots[i], -1, static_cast<Index>(i)},
            plan);
}

void addModelValues(TrialPlan &plan)
{
    for (const Characteristic &one : kCharacteristics)
        if (const ReportedValue *reported = plan.subject.report.find(one.of))
            addQuantity({one.of, *reported, -1, -1, one.value}, plan);
}

/// Makes single trials of a plan.
class TrialMaker
{
public:
    explicit TrialMaker(const TrialPlan &plan)
        : m_plan(plan)
    {
        if (ModelDraws::canDraw(plan.subject))
            m_model.emplace(plan.subject, plan.inputs);
    }

    void make(Index trial, TrialBlock &block) const
    {
        const Index row = trial - block.begin;
        const ChainInputs &inputs = m_plan.inputs;
        const Eigen::VectorXd p = inputs.sources.probabilities(m_plan.seed, trial);
        const DrawnSensitivities drawn = drawnSensitivities(m_plan.subject, inputs, p);
        const auto ofModel
            = m_model ? std::optional(m_model->values(m_plan.seed, trial, p)) : std::nullopt;
        block.common[row] = drawn.common;
        block.front_s[row] = std::max(0.0, inputs.front.value(p));
        block.drift[row] = inputs.drift.value(p);
        for (Index i = 0; i < block.values.cols(); ++i)
            block.values(row, i)
                = valueOf(m_plan.quantities[static_cast<std::size_t>(i)], drawn, ofModel);
    }

private:
    static double valueOf(const TrialQuantity &quantity, const DrawnSensitivities &drawn,
        const std::optional<CharacteristicValues> &ofModel)
    {
        if (quantity.ofModel)
            return (*ofModel).*quantity.ofModel;
        return quantity.shot >= 0 ? drawn.ofShots[quantity.shot] : drawn.ofMeans[quantity.mean];
    }

    const TrialPlan &m_plan;
    std::optional<ModelDraws> m_model;
};

TrialBlock emptyBlock(Index begin, Index count, Index quantities)
{
    return {begin, Eigen::MatrixXd(count, quantities), Eigen::VectorXd(count),
        Eigen::VectorXd(count), Eigen::VectorXd(count)};
}

void place(const TrialBlock &from, Index at, TrialBlock &into)
{
    into.values.middleRows(at, from.count()) = from.values;
    into.common.segment(at, from.count()) = from.common;
    into.front_s.segment(at, from.count()) = from.front_s;
    into.drift.segment(at, from.count()) = from.drift;
}

} // namespace

TrialPlan trialPlan(const ChainSubject &subject, std::uint64_t seed)
{
    TrialPlan plan{subject, chainInputs(subject), {}, seed};
    addSensitivities(plan);
    if (ModelDraws::canDraw(subject))
        addModelValues(plan);
    return plan;
}

Result<TrialBlock> runTrials(
    const TrialPlan &plan, Index begin, Index count, const JobControl &control)
{
    const TrialMaker maker(plan);
    TrialBlock block = emptyBlock(begin, count, std::ssize(plan.quantities));
    std::atomic<Index> done = 0;
    const Index parts = (count + kPart - 1) / kPart;
    forEachPart(parts, true, [&](Index part) {
        const Index end = std::min(count, (part + 1) * kPart);
        for (Index i = part * kPart; i < end && !control.stopRequested(); ++i)
            maker.make(begin + i, block);
        done += end - part * kPart;
    });
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    return block;
}

Result<TrialBlock> mergedBlocks(const std::vector<TrialBlock> &blocks)
{
    Index count = 0;
    for (const TrialBlock &block : blocks) {
        if (block.begin != blocks.front().begin + count
            || block.values.cols() != blocks.front().values.cols())
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "The blocks of trials do not fit together: one begins with trial %1, expected is %2; merge blocks of one calibration, in their order."),
                    {std::to_string(block.begin), std::to_string(blocks.front().begin + count)}});
        count += block.count();
    }
    if (blocks.empty())
        return TrialBlock();
    TrialBlock all = emptyBlock(blocks.front().begin, count, blocks.front().values.cols());
    for (const TrialBlock &block : blocks)
        place(block, block.begin - all.begin, all);
    return all;
}

} // namespace dyncal
