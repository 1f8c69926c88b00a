// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/transducer_steps.h"

#include "core/model_analysis/noise_density.h"
#include "core/reference/reference_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

constexpr double kUnstatedGain = 0.005; ///< half width, as of the DUT's chain

UncertainInput gainInput(const std::vector<StatedUncertainty> &stated)
{
    UncertainInput input{
        kReferenceGain, 1.0, kUnstatedGain / std::sqrt(3.0), Distribution::Rectangular};
    input.common = true;
    const auto found = std::ranges::find(stated, input.quantity, &StatedUncertainty::quantity);
    if (found == stated.end())
        return input;
    input.u = found->u;
    input.distribution = found->distribution;
    input.dof = found->dof.value_or(input.dof);
    input.correlated = found->correlated;
    return input;
}

/// Noise of the settled level against the baseline, relative to the step.
double uLevel_relative(const WindowedResponse &response)
{
    const auto samples
        = static_cast<Index>(std::max(1.0, response.settle_s.length() * response.sampleRate_Hz));
    const NoiseDensity noise(response);
    const double variance = noise.ofMean(samples, 2 * response.length) + noise.ofBaseline();
    return std::sqrt(variance) * std::abs(response.valueScale / response.step);
}

/// What the level is divided by. Where the table begins above what the record resolves, u has what
/// the sensitivity may change below it.
ReferencePoint sensitivityAtLevel(
    const ReferenceRecords &reference, const WindowedResponse &response)
{
    ReferencePoint point = reference.sensitivity.lowest();
    if (beginsAboveTheLevel(reference.sensitivity, response))
        point.u_magnitude = std::hypot(point.u_magnitude, reference.sensitivity.changeBelow());
    return point;
}

std::optional<StepUncertainty> uncertaintyOf(const ReferenceRecords &reference,
    const WindowedResponse &response, double step_Pa, const UncertainInput &gain)
{
    const ReferencePoint S_ref = sensitivityAtLevel(reference, response);
    if (!std::isfinite(S_ref.u_magnitude))
        return std::nullopt;
    const std::vector<UncertainInput> inputs{
        {"reference_sensitivity_relative", 1.0, S_ref.u_magnitude / S_ref.magnitude,
            Distribution::Normal, S_ref.dof, true},
        gain, {"reference_level_relative", 1.0, uLevel_relative(response)}};
    auto budget = propagateGum(inputs, [=](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(kStepResults);
        all[static_cast<Index>(StepResult::Step)] = stepByTransducer(step_Pa, x);
        return all;
    });
    if (!budget)
        return std::nullopt;
    const Message none{
        DYNCAL_TEXT("core", "The step is that of a reference transducer, not of the shock."), {}};
    return StepUncertainty{std::move(*budget), none, none, {}};
}

} // namespace

double stepByTransducer(double step_Pa, const Eigen::VectorXd &inputs)
{
    return step_Pa * inputs[2] / (inputs[0] * inputs[1]);
}

ShockConditionsSet stepsByTransducer(const ReferenceRecords &reference,
    const ShockConditionsSet &shock, const std::vector<StatedUncertainty> &stated)
{
    const UncertainInput gain = gainInput(stated);
    const double S_ref = reference.sensitivity.lowest().magnitude;
    ShockConditionsSet steps;
    for (const WindowedResponse &response : reference.responses) {
        const ShockConditions *known = shock.ofShot(response.shot);
        ShockConditions shot = known ? *known : ShockConditions();
        shot.shot = response.shot;
        shot.stepTyped = false;
        shot.step_Pa = std::abs(response.step) / S_ref;
        shot.uncertainty = uncertaintyOf(reference, response, *shot.step_Pa, gain);
        steps.shots.push_back(std::move(shot));
    }
    return steps;
}

} // namespace dyncal
