// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/sensitivity_draws.h"

#include "core/model_analysis/transducer_steps.h"

#include <algorithm>
#include <vector>

namespace dyncal {
namespace {

/// Inputs that only this shot has stay as they are where the scatter of the shots stands for them.
enum class OwnInputs { Drawn, Kept };

/// What the pressure step makes of a sensitivity, 1 as found.
double byStep(const ShotChain &shot, const Eigen::VectorXd &probabilities, OwnInputs own)
{
    Eigen::VectorXd x(std::ssize(shot.ofStep));
    for (Index i = 0; i < x.size(); ++i) {
        const DrawnInput &one = shot.ofStep[static_cast<std::size_t>(i)];
        x[i] = one.input.common || own == OwnInputs::Drawn ? one.value(probabilities)
                                                           : one.input.value;
    }
    const Result<double> step_Pa = shot.stepAt_Pa(x);
    return step_Pa && *step_Pa > 0.0 ? shot.step_Pa / *step_Pa : kUnknown;
}

double byFactors(const ChainInputs &inputs, const Eigen::VectorXd &probabilities, bool ofLevels)
{
    double product = 1.0;
    for (const ChainFactor &factor : inputs.factors) {
        if (factor.ofLevelsOnly && !ofLevels)
            continue;
        const double one = 1.0 + factor.x.value(probabilities);
        product *= factor.divides ? 1.0 / one : one;
    }
    return product;
}

/// Of a shot's sensitivity: its step, with and without the noise of its level.
struct ShotFactors
{
    double byStep = 1.0;
    double byLevel = 1.0;
};

ShotFactors factorsOf(const ShotChain &shot, const Eigen::VectorXd &probabilities, OwnInputs own)
{
    return {byStep(shot, probabilities, own),
        own == OwnInputs::Drawn ? 1.0 + shot.ofLevel.value(probabilities) : 1.0};
}

std::vector<ShotFactors> factorsOfAll(
    const ChainInputs &inputs, const Eigen::VectorXd &probabilities, OwnInputs own)
{
    std::vector<ShotFactors> all;
    all.reserve(inputs.shots.size());
    for (const ShotChain &shot : inputs.shots)
        all.push_back(factorsOf(shot, probabilities, own));
    return all;
}

double scatterOf(const ShotScatter &mean, const Eigen::VectorXd &probabilities)
{
    return mean.scatter ? 1.0 + mean.scatter->value(probabilities) : 1.0;
}

/// Mean over the shots of one mean, with or without the noise of the levels.
double meanOfShots(const ChainInputs &inputs, const ShotScatter &mean,
    const std::vector<ShotFactors> &factors, bool withLevels)
{
    double sum = 0.0;
    for (const std::size_t i : mean.of)
        sum += inputs.shots[i].sensitivity * factors[i].byStep
            * (withLevels ? factors[i].byLevel : 1.0);
    return sum / static_cast<double>(mean.of.size());
}

/// Against a transducer its chain is all that its rows have in common.
double commonStep(const ChainSubject &subject, const ChainInputs &inputs,
    const std::vector<ShotFactors> &factors, const Eigen::VectorXd &probabilities)
{
    if (!subject.response.isByTransducer)
        return meanOfShots(inputs, inputs.means.front(), factors, false)
            / *subject.response.sensitivity * scatterOf(inputs.means.front(), probabilities);
    const auto &list = inputs.shots.front().ofStep;
    const auto gain = std::ranges::find_if(
        list, [](const DrawnInput &one) { return one.input.quantity == kReferenceGain; });
    return gain == list.end() ? 1.0 : gain->value(probabilities); // S = S_ref Y/Y_ref of its gain
}

/// A level that is larger than found makes the relative response smaller.
double byLevels(const std::vector<DrawnInput> &levels, const Eigen::VectorXd &probabilities)
{
    double sum = 0.0;
    for (const DrawnInput &level : levels)
        sum += 1.0 + level.value(probabilities);
    return levels.empty() ? 1.0 : static_cast<double>(levels.size()) / sum;
}

double commonOfRows(const ChainSubject &subject, const ChainInputs &inputs,
    const std::vector<ShotFactors> &factors, const Eigen::VectorXd &probabilities)
{
    if (inputs.means.empty() || !inputs.levels.empty())
        return byLevels(inputs.levels, probabilities);
    return commonStep(subject, inputs, factors, probabilities)
        * byFactors(inputs, probabilities, false);
}

} // namespace

DrawnSensitivities drawnSensitivities(
    const ChainSubject &subject, const ChainInputs &inputs, const Eigen::VectorXd &probabilities)
{
    DrawnSensitivities drawn;
    const double chain = byFactors(inputs, probabilities, true);
    const auto own = factorsOfAll(inputs, probabilities, OwnInputs::Drawn);
    const bool isScatter = !inputs.means.empty() && inputs.means.front().scatter;
    const auto kept = isScatter ? factorsOfAll(inputs, probabilities, OwnInputs::Kept) : own;
    drawn.ofMeans.resize(std::ssize(inputs.means));
    for (std::size_t i = 0; i < inputs.means.size(); ++i)
        drawn.ofMeans[static_cast<Index>(i)] = chain
            * meanOfShots(inputs, inputs.means[i], kept, true)
            * scatterOf(inputs.means[i], probabilities);
    drawn.ofShots.resize(std::ssize(inputs.shots));
    for (std::size_t i = 0; i < inputs.shots.size(); ++i)
        drawn.ofShots[static_cast<Index>(i)]
            = chain * inputs.shots[i].sensitivity * own[i].byStep * own[i].byLevel;
    drawn.common = commonOfRows(subject, inputs, kept, probabilities);
    return drawn;
}

} // namespace dyncal
