// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/sensor_response.h"
#include "core/realization/model/model_variation.h"
#include "core/uncertainty/chain_effects.h"
#include "core/uncertainty/reported_value.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// Complete uncertainties of S(f), row by row as in ResponseResult. What all rows share (step,
/// chain) is apart from what is a row's own (noise, end, aliasing, front, onset). NaN where a value
/// is withheld, or its u is not complete.
struct RowUncertainty
{
    std::vector<UncertaintyLine> common; ///< relative, of every magnitude
    double u_common_relative = kUnknown; ///< NaN where the step's is not known
    double u_commonOfModel_relative = kUnknown;
    Eigen::VectorXd u_magnitude;
    Eigen::VectorXd k_magnitude;
    Eigen::VectorXd dof_magnitude;
    Eigen::VectorXd u_phase_rad;
    Eigen::VectorXd k_phase;
    Eigen::VectorXd dof_phase;
    Eigen::MatrixX3d covarianceReIm; ///< var Re S, cov, var Im S, of the row's own part
    Eigen::VectorXd u_modelMagnitude;
    Eigen::VectorXd u_modelPhase_rad;
    Eigen::VectorXd leastExpanded_relative; ///< CMC of the magnitudes; empty without one
    Eigen::VectorXd leastExpandedPhase_rad;
    Eigen::VectorXd e_n; ///< of measured less model; they share all that is common

    bool isComplete() const { return std::isfinite(u_common_relative); }
};

/// What all magnitudes share, relative.
struct CommonLines
{
    std::vector<UncertaintyLine> ofRows; ///< of the measured ones
    std::vector<UncertaintyLine>
        ofModel; ///< also a reference's sensitivity, which rows have as own
};

/// `common`: empty = not known. `variations`: modelVariations() of
/// the model; the model's response has their u, that of the front and the common part.
RowUncertainty rowUncertainty(const ResponseResult &response,
    const std::optional<CommonLines> &common, const SensorModel &model,
    const std::vector<ModelVariation> &variations, ResponseTreatment treatment);

/// One row's magnitude with its lines, the common ones first, and the CMC's. The row must not be
/// withheld, and the common part known.
ReportedValue magnitudeOfRow(const ResponseResult &response, const RowUncertainty &rows, Index row);

/// The same of its phase, in rad; without u where a part of it is not known.
ReportedValue phaseOfRow(const ResponseResult &response, const RowUncertainty &rows, Index row);

} // namespace dyncal
