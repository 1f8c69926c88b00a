// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_variation.h"

#include "core/realization/model/model_description.h"
#include "core/realization/model/onset_level.h"
#include "core/realization/model/series_fit.h"
#include "core/realization/refinement/model_draft.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dyncal {
namespace {

/// Columns L with V = L L^T. Eigenvectors of the correlation matrix: the parameters' units differ
/// by many orders of magnitude.
Eigen::MatrixXd directionsOf(const Eigen::MatrixXd &V)
{
    constexpr double kNone = 1e-12; // of the largest eigenvalue: rounding of a tied parameter
    const Eigen::VectorXd sd = V.diagonal().cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd scale = sd.unaryExpr([](double u) { return u > 0.0 ? 1.0 / u : 0.0; });
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        scale.asDiagonal() * V * scale.asDiagonal());
    const Eigen::VectorXd &values = solver.eigenvalues();
    std::vector<Index> kept;
    for (Index i = 0; i < values.size(); ++i)
        if (values[i] > kNone * values[values.size() - 1])
            kept.push_back(i);
    return sd.asDiagonal() * solver.eigenvectors()(Eigen::all, kept)
        * values(kept).cwiseSqrt().asDiagonal();
}

/// The part of all parameters that one record has, in the order of perturbed().
Eigen::VectorXd ofRecord(const Refinement &fit, const Eigen::VectorXd &all, std::size_t record)
{
    const Index n = fit.poleParameters;
    const Index own = n + (fit.withConstant ? 1 : 0);
    Eigen::VectorXd deltas(n + own);
    deltas << all.head(n), all.segment(fit.offsets[record], own);
    return deltas;
}

class Mover
{
public:
    Mover(const ModelInput &input, const SensorModel &model)
        : m_input(input)
        , m_model(model)
        , m_standsOut(standingOut(input, model.draft))
        , m_isSlow(model.draft.poles_rad_s.size(), false)
    {
        for (const Index i : model.slowPoles)
            m_isSlow[static_cast<std::size_t>(i)] = true;
    }

    ModelVariation along(const Eigen::VectorXd &direction) const
    {
        ModelVariation variation{base(), base()};
        for (std::size_t r = 0; r < m_model.series.size(); ++r) {
            const Eigen::VectorXd deltas = kVariation * ofRecord(fit(), direction, r);
            const auto record = static_cast<Index>(r);
            const ExponentialSum up = perturbed(fit(), record, deltas);
            const ExponentialSum down = perturbed(fit(), record, -deltas);
            const double onset_s = m_model.series[r].onset_s;
            // An onset that one of them has not stays where it was in both.
            const auto above = onsetOf(m_input, m_model.draft, r, m_standsOut, up);
            const auto below = onsetOf(m_input, m_model.draft, r, m_standsOut, down);
            const bool moves = above && below;
            add(up, r, moves ? *above : onset_s, variation.up);
            add(down, r, moves ? *below : onset_s, variation.down);
        }
        poolShapes(m_input, variation.up);
        poolShapes(m_input, variation.down);
        return variation;
    }

private:
    const Refinement &fit() const { return *m_model.draft.refinement; }

    SensorModel base() const
    {
        SensorModel moved;
        moved.order = m_model.order;
        moved.poles = m_model.poles;
        moved.slowPoles = m_model.slowPoles;
        return moved;
    }

    void add(const ExponentialSum &sum, std::size_t r, double onset_s, SensorModel &moved) const
    {
        for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
            moved.poles[static_cast<std::size_t>(i)].s_rad_s = sum.poles_rad_s[i];
        SeriesFit one;
        one.shot = m_model.series[r].shot;
        one.plateauGain = sum.constant;
        one.onset_s = onset_s;
        one.amplitudes = amplitudesAt(m_input, m_model.draft, r, sum, onset_s);
        if (!m_model.slowPoles.empty()) {
            const OnsetLevel level
                = onsetLevel({sum.constant, sum.poles_rad_s, one.amplitudes}, m_isSlow);
            one.stepLevel = level.value;
            one.sensorStep = level.sensor;
        }
        moved.series.push_back(std::move(one));
    }

    const ModelInput &m_input;
    const SensorModel &m_model;
    std::vector<bool> m_standsOut;
    std::vector<bool> m_isSlow;
};

} // namespace

std::vector<ModelVariation> modelVariations(const ModelInput &input, const SensorModel &model)
{
    std::vector<ModelVariation> variations;
    if (!model.draft.refinement || !isStepTreatment(input.treatment) || model.diverges)
        return variations;
    const Mover mover(input, model);
    const Eigen::MatrixXd directions = directionsOf(model.draft.refinement->covariance);
    for (Index i = 0; i < directions.cols(); ++i)
        variations.push_back(mover.along(directions.col(i)));
    return variations;
}

} // namespace dyncal
