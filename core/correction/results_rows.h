// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/correction/known_response.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace dyncal {

// Internal to core/correction: the rows of a results.json and their budgets as values.

/// The rows that are complete, from the first on as far as they follow each other closely.
struct MeasuredRows
{
    std::vector<std::size_t> number; ///< in results.json, of each row here
    Eigen::VectorXd frequency_Hz;
    Eigen::VectorXcd S;
    Eigen::VectorXd u_magnitude;
    Eigen::VectorXd u_phase_rad;
};

/// Two rows further apart than this leave too much to the model; rows behind are not used.
inline constexpr double kWidestGap = 2.1;

/// Fails (Usage) where the lists differ in length or the frequencies do not ascend; (DataBlocked)
/// where no row is complete.
Result<MeasuredRows> measuredRows(const nlohmann::json &response);

/// The errors of the rows behind a first knot at 0 Hz, whose value is the sensitivity: noise, end
/// and aliasing of each row apart, all other lines of one name and shot together. Fails
/// (DataBlocked) where a row has no lines, (Usage) where they do not make its u within 0.1 %.
Result<std::vector<ResponseError>> rowErrors(
    const nlohmann::json &budget, const MeasuredRows &rows, double sensitivity);

/// What each knot has alone, relative: by the errors that are of one knot only; above 0 Hz the mean
/// square of magnitude and phase.
Eigen::VectorXd uOfKnotsAlone(const std::vector<ResponseError> &errors, Index knots);

} // namespace dyncal
