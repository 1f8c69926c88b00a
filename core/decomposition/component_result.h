// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/decomposition/principal_components.h"
#include "core/decomposition/residual_analysis.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

struct ComponentResult
{
    std::vector<Index> shots; ///< numbers of the shots used, from 1
    double sampleRate_Hz = 0.0; ///< common rate: the lowest among the shots
    std::optional<PrincipalComponents> principal; ///< empty with one shot (CAP-017)
    Eigen::MatrixXd responses; ///< samples x shots at the common rate, from the start on
    Eigen::MatrixXd reconstructions;
    Eigen::VectorXd average; ///< of the reconstructions; of one shot: the shot itself
    std::vector<ResidualAnalysis> residuals; ///< per shot; empty with one shot
    Index kept = 1; ///< components in the reconstructions: as set, at most the shots
    Findings findings; ///< PCA-001..004, CAP-017, CAP-004 (info) when rates were unified
};

} // namespace dyncal
