// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/chain_inputs.h"

#include "core/model_analysis/transducer_steps.h"
#include "core/uncertainty/chain_effects.h"
#include "core/uncertainty/front_effect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace dyncal {
namespace {

using StepFunction = std::function<Result<double>(const Eigen::VectorXd &)>;

/// A measured step with the list of its inputs, which refers to both others.
struct MeasuredStep
{
    StepMeasurement measurement;
    std::vector<StatedUncertainty> stated;
    StepInputs list;

    MeasuredStep(const StepMeasurement &m, const std::vector<StatedUncertainty> &s)
        : measurement(m)
        , stated(s)
        , list(measurement, stated)
    {
    }
    MeasuredStep(const MeasuredStep &) = delete;
    MeasuredStep &operator=(const MeasuredStep &) = delete;
    MeasuredStep(MeasuredStep &&) = delete;
    MeasuredStep &operator=(MeasuredStep &&) = delete;
    ~MeasuredStep() = default;
};

StepFunction measuredStep(std::shared_ptr<const MeasuredStep> step)
{
    return [step = std::move(step)](const Eigen::VectorXd &x) -> Result<double> {
        const StepMeasurement &m = step->measurement;
        const StepPoint point = step->list.at(x);
        const auto states = statesAt(m, point, velocityAt(m, point));
        return states ? Result<double>(stepAt(m, point, *states))
                      : Result<double>(tl::unexpected(states.error()));
    };
}

std::vector<UncertainInput> inputsOf(const GumBudget &budget)
{
    std::vector<UncertainInput> inputs;
    for (const BudgetLine &line : budget.lines)
        inputs.push_back(line.input);
    return inputs;
}

/// Of the shock; null where the budget is that of a typed step alone.
std::shared_ptr<const MeasuredStep> stepOfShock(
    const ShockConditions &known, const std::vector<StatedUncertainty> &stated)
{
    if (!known.measurement)
        return nullptr;
    auto step = std::make_shared<const MeasuredStep>(*known.measurement, stated);
    const bool isOfBudget = step->list.inputs().size() == known.uncertainty->budget.lines.size();
    return isOfBudget ? step : nullptr;
}

StepFunction stepFunction(const ChainSubject &subject, const ShockConditions &known)
{
    const double step_Pa = *known.step_Pa;
    if (subject.response.isByTransducer)
        return [=](const Eigen::VectorXd &x) { return stepByTransducer(step_Pa, x); };
    if (auto step = stepOfShock(known, subject.stated))
        return measuredStep(std::move(step));
    return [=](const Eigen::VectorXd &x) { return step_Pa * x[0]; };
}

void addStep(
    const ChainSubject &subject, const ShockConditions &known, ChainInputs &inputs, ShotChain &shot)
{
    shot.stepAt_Pa = stepFunction(subject, known);
    for (const UncertainInput &input : inputsOf(known.uncertainty->budget))
        shot.ofStep.push_back({input, inputs.sources.add(input, shot.shot)});
}

DrawnInput drawn(ChainInputs &inputs, UncertainInput input, Index shot = 0)
{
    input.common = shot == 0;
    const Index source = inputs.sources.add(input, shot);
    return {std::move(input), source};
}

/// A line of the budget as the source that it is of, about 0.
UncertainInput sourceOf(const UncertaintyLine &line)
{
    return {line.quantity, 0.0, line.u, line.distribution, line.dof, true, line.correlated};
}

bool hasCompleteShots(const ChainSubject &subject)
{
    const auto &shots = subject.response.shots;
    return !shots.empty() && std::ranges::all_of(shots, [&](const ShotSensitivity &shot) {
        const ShockConditions *known = subject.shock.ofShot(shot.shot);
        return shot.u && shot.step_Pa && known && known->step_Pa && known->uncertainty;
    });
}

bool isRelative(const ResponseResult &response)
{
    return !response.sensitivity || response.unit != response.sensitivityUnit;
}

DrawnInput levelInput(const ChainSubject &subject, const ShotSensitivity &shot, ChainInputs &inputs)
{
    const double dof = subject.model.draft.noise.dof;
    return drawn(inputs,
        {kLevelRelative, 0.0, shot.uLevel_relative, Distribution::Normal,
            dof > 0.0 ? dof : std::numeric_limits<double>::infinity()},
        shot.shot);
}

void addShots(const ChainSubject &subject, ChainInputs &inputs)
{
    if (!hasCompleteShots(subject))
        return;
    for (const ShotSensitivity &one : subject.response.shots) {
        ShotChain shot{one.shot, one.level, *one.sensitivity, *one.step_Pa, {}, {}, {}};
        addStep(subject, *subject.shock.ofShot(one.shot), inputs, shot);
        shot.ofLevel = levelInput(subject, one, inputs);
        inputs.shots.push_back(std::move(shot));
    }
}

void addLevels(const ChainSubject &subject, ChainInputs &inputs)
{
    const auto &shots = subject.response.shots;
    const auto isKnown
        = [](const ShotSensitivity &shot) { return std::isfinite(shot.uLevel_relative); };
    if (!isRelative(subject.response) || !std::ranges::all_of(shots, isKnown))
        return;
    for (const ShotSensitivity &shot : shots)
        inputs.levels.push_back(levelInput(subject, shot, inputs));
}

void addMean(const SensitivityMean &mean, ChainInputs &inputs)
{
    ShotScatter one;
    for (std::size_t i = 0; i < inputs.shots.size(); ++i)
        if (mean.level == ShotLevel::None || inputs.shots[i].level == mean.level)
            one.of.push_back(i);
    const auto line
        = std::ranges::find(mean.lines, std::string(kScatterOfShots), &UncertaintyLine::quantity);
    if (!inputs.means.empty() && one.of == inputs.means.front().of) { // the same mean once more
        one.scatter = inputs.means.front().scatter;
    } else if (line != mean.lines.end()) {
        UncertainInput input = sourceOf(*line);
        input.quantity += std::string(" ") + shotLevelName(mean.level);
        one.scatter = drawn(inputs, std::move(input));
    }
    inputs.means.push_back(std::move(one));
}

void addMeans(const ChainSubject &subject, ChainInputs &inputs)
{
    if (inputs.shots.empty() || !subject.response.summary.mean)
        return;
    addMean(*subject.response.summary.mean, inputs);
    for (const SensitivityMean &level : subject.response.summary.perLevel)
        addMean(level, inputs);
}

void addFactors(const ChainSubject &subject, ChainInputs &inputs)
{
    for (const UncertaintyLine &line : subject.report.chain.ofSensitivity) {
        inputs.factors.push_back({drawn(inputs, sourceOf(line)), line.sensitivity < 0.0});
        if (line.quantity == kMounting)
            inputs.mounting = inputs.factors.back().x;
    }
    if (subject.response.isWithoutChain)
        inputs.factors.push_back(
            {drawn(inputs, {kChainLevel, 0.0, subject.response.u_chainLowest_relative}), true,
                true});
}

/// Of a front that nobody stated anything from 0 to kUnstatedFront_s.
UncertainInput frontInput(const FrontDuration &front)
{
    if (isFrontStated(front))
        return {"front_duration_s", front.duration_s, front.u_s};
    return {"front_unknown", 0.5 * kUnstatedFront_s, 0.5 * kUnstatedFront_s / std::numbers::sqrt3,
        Distribution::Rectangular};
}

} // namespace

ChainInputs chainInputs(const ChainSubject &subject)
{
    ChainInputs inputs;
    addShots(subject, inputs);
    addMeans(subject, inputs);
    addLevels(subject, inputs);
    addFactors(subject, inputs);
    inputs.clock = drawn(inputs, sourceOf(subject.report.chain.clock));
    inputs.front = drawn(inputs, frontInput(subject.response.front));
    inputs.drift = drawn(inputs, {"drift", 0.0, 1.0});
    inputs.weakMode = drawn(inputs, {"weak_mode"}).source;
    return inputs;
}

} // namespace dyncal
