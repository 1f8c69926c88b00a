// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/chain_inputs.h"
#include "core/realization/model/model_mover.h"
#include "core/uncertainty/characteristic_values.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace dyncal {

/// Draws the model as noise like that of its records would have made it: the step of Gauss and
/// Newton from the fitted parameters, J^T W n over (J^T W J)^-1, whose covariance is that of the
/// refinement. All its parameters are drawn together, then every value of it is found anew by its
/// own definition. Const and safe to use from several threads; the subject must outlive it.
class ModelDraws
{
public:
    /// Needs a refinement, and a model that does not diverge (see canDraw()).
    ModelDraws(const ChainSubject &subject, const ChainInputs &inputs);

    static bool canDraw(const ChainSubject &subject);

    /// `probabilities` of the sources: front, mounting, clock, weak mode.
    CharacteristicValues values(
        std::uint64_t seed, Index trial, const Eigen::VectorXd &probabilities) const;

    /// The same, of the noise of the records alone: the front and the clock as assumed, all modes
    /// the sensor's, and no scatter of the shots.
    CharacteristicValues valuesByNoise(std::uint64_t seed, Index trial) const;

    /// The drawn deviation of all parameters, as their covariance has it.
    Eigen::VectorXd deltas(std::uint64_t seed, Index trial) const;

private:
    SensorModel movedBy(const Eigen::VectorXd &deltas, double front_s, bool withWeak) const;
    void narrowPoles(CharacteristicValues &values) const;
    void addClock(double clock_relative, CharacteristicValues &values) const;

    const ChainSubject &m_subject;
    const ChainInputs &m_inputs;
    ModelMover m_mover;
    MainPair m_pair;
    Eigen::MatrixXd m_directions;
    double m_dof = 0.0;
    double m_wider = 1.0; ///< where the shots' scatter stands for the noise
    double m_frequencyShare = 1.0; ///< of that, of f0 and of the damping
    double m_dampingShare = 1.0;
    CharacteristicValues m_fitted;
};

} // namespace dyncal
