// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

/// Columns L with V = L L^T: eigenvectors of the correlation matrix, because the units of the
/// parameters differ by many orders of magnitude. Directions without any variance are left out.
Eigen::MatrixXd directionsOf(const Eigen::MatrixXd &V);

/// Makes of a refined model others whose parameters (in the order of Refinement::covariance)
/// differ: its onsets found again, its shots pooled again; which poles are a drift stays as
/// decided. Of these models only poles, amplitudes, plateau, level and the sensor's own step are
/// filled in. `input` and `model` (with a refinement, of a step) must outlive it; const and safe
/// to use from several threads.
class ModelMover
{
public:
    ModelMover(const ModelInput &input, const SensorModel &model);

    /// The model with all parameters moved by `deltas`. An onset that it has not stays.
    SensorModel moved(const Eigen::VectorXd &deltas) const;

    // The parts of moved(), where two models have to move alike.
    SensorModel bare() const; ///< neither series nor shapes
    ExponentialSum sumOf(std::size_t record, const Eigen::VectorXd &deltas) const;
    std::optional<double> onset_s(std::size_t record, const ExponentialSum &sum) const;
    void add(
        const ExponentialSum &sum, std::size_t record, double onset_s, SensorModel &moved) const;
    void pool(SensorModel &moved) const;

private:
    const Refinement &fit() const { return *m_model.draft.refinement; }

    const ModelInput &m_input;
    const SensorModel &m_model;
    std::vector<bool> m_standsOut;
    std::vector<bool> m_isSlow;
};

} // namespace dyncal
