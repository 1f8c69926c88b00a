// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

namespace dyncal {

/// Principal components across shots: X (samples x shots) = mean + U S V^T, via QR and a small SVD
/// (the Gram matrix would lose components below 1e-8 of the first).
struct PrincipalComponents
{
    Eigen::VectorXd singularValues; ///< one per shot, largest first
    Eigen::VectorXd explainedCumulative_percent; ///< 100 sum s_i^2 / sum s^2
    Eigen::MatrixXd components; ///< samples x shots: U
    Eigen::MatrixXd scores; ///< shots x shots: S V^T, column per shot
    Eigen::VectorXd mean; ///< empty unless centred
};

/// `shots`: samples x shots, at least one of each, finite. With fewer samples than shots there are
/// as many components as samples. Signs: docs/method/principal-components.md.
PrincipalComponents computePrincipalComponents(const Eigen::MatrixXd &shots, bool centre);

/// Reconstruction of every shot from the first `kept` components (1..their number): samples x
/// shots.
Eigen::MatrixXd reconstruct(const PrincipalComponents &components, Index kept);

} // namespace dyncal
