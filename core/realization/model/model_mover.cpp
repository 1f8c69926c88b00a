// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_mover.h"

#include "core/realization/model/model_description.h"
#include "core/realization/model/onset_level.h"
#include "core/realization/model/series_fit.h"
#include "core/realization/refinement/model_draft.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <utility>

namespace dyncal {
namespace {

/// The part of all parameters that one record has, in the order of perturbed().
Eigen::VectorXd ofRecord(const Refinement &fit, const Eigen::VectorXd &all, std::size_t record)
{
    const Index n = fit.poleParameters;
    const Index own = n + (fit.withConstant ? 1 : 0);
    Eigen::VectorXd deltas(n + own);
    deltas << all.head(n), all.segment(fit.offsets[record], own);
    return deltas;
}

} // namespace

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

ModelMover::ModelMover(const ModelInput &input, const SensorModel &model)
    : m_input(input)
    , m_model(model)
    , m_standsOut(standingOut(input, model.draft))
    , m_isSlow(model.draft.poles_rad_s.size(), false)
{
    for (const Index i : model.slowPoles)
        m_isSlow[static_cast<std::size_t>(i)] = true;
}

SensorModel ModelMover::bare() const
{
    SensorModel moved;
    moved.order = m_model.order;
    moved.poles = m_model.poles;
    moved.slowPoles = m_model.slowPoles;
    return moved;
}

ExponentialSum ModelMover::sumOf(std::size_t record, const Eigen::VectorXd &deltas) const
{
    return perturbed(fit(), static_cast<Index>(record), ofRecord(fit(), deltas, record));
}

std::optional<double> ModelMover::onset_s(std::size_t record, const ExponentialSum &sum) const
{
    return onsetOf(m_input, m_model.draft, record, m_standsOut, sum);
}

void ModelMover::add(
    const ExponentialSum &sum, std::size_t record, double onset_s, SensorModel &moved) const
{
    for (Index i = 0; i < sum.poles_rad_s.size(); ++i)
        moved.poles[static_cast<std::size_t>(i)].s_rad_s = sum.poles_rad_s[i];
    SeriesFit one;
    one.shot = m_model.series[record].shot;
    one.plateauGain = sum.constant;
    one.onset_s = onset_s;
    one.amplitudes = amplitudesAt(m_input, m_model.draft, record, sum, onset_s);
    if (!m_model.slowPoles.empty()) {
        const OnsetLevel level
            = onsetLevel({sum.constant, sum.poles_rad_s, one.amplitudes}, m_isSlow);
        one.stepLevel = level.value;
        one.sensorStep = level.sensor;
    }
    moved.series.push_back(std::move(one));
}

void ModelMover::pool(SensorModel &moved) const
{
    poolShapes(m_input, moved);
}

SensorModel ModelMover::moved(const Eigen::VectorXd &deltas) const
{
    SensorModel moved = bare();
    for (std::size_t record = 0; record < m_model.series.size(); ++record) {
        const ExponentialSum sum = sumOf(record, deltas);
        add(sum, record, onset_s(record, sum).value_or(m_model.series[record].onset_s), moved);
    }
    pool(moved);
    return moved;
}

} // namespace dyncal
