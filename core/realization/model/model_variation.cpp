// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_variation.h"

#include "core/realization/model/model_mover.h"

namespace dyncal {
namespace {

ModelVariation along(
    const ModelMover &mover, const SensorModel &model, const Eigen::VectorXd &direction)
{
    ModelVariation variation{mover.bare(), mover.bare()};
    const Eigen::VectorXd deltas = kVariation * direction;
    for (std::size_t r = 0; r < model.series.size(); ++r) {
        const ExponentialSum up = mover.sumOf(r, deltas);
        const ExponentialSum down = mover.sumOf(r, -deltas);
        const double onset_s = model.series[r].onset_s;
        // An onset that one of them has not stays where it was in both.
        const auto above = mover.onset_s(r, up);
        const auto below = mover.onset_s(r, down);
        const bool moves = above && below;
        mover.add(up, r, moves ? *above : onset_s, variation.up);
        mover.add(down, r, moves ? *below : onset_s, variation.down);
    }
    mover.pool(variation.up);
    mover.pool(variation.down);
    return variation;
}

} // namespace

std::vector<ModelVariation> modelVariations(const ModelInput &input, const SensorModel &model)
{
    std::vector<ModelVariation> variations;
    if (!model.draft.refinement || !isStepTreatment(input.treatment) || model.diverges)
        return variations;
    const ModelMover mover(input, model);
    const Eigen::MatrixXd directions = directionsOf(model.draft.refinement->covariance);
    for (Index i = 0; i < directions.cols(); ++i)
        variations.push_back(along(mover, model, directions.col(i)));
    return variations;
}

} // namespace dyncal
