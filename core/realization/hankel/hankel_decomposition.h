// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/realization_settings.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dyncal {

/// Leading singular triplets of the matrix that was decomposed. One decomposition serves all
/// orders: the shift-invariance and Ho-Kalman matrices of order n follow from the leading n x n
/// blocks of the matrices kept here (docs/method/hankel.md).
struct HankelDecomposition
{
    Index rows = 0; ///< r
    Index columns = 0; ///< s, summed over the stacked series
    bool onesProjected = false; ///< right projection that removes the step's pole at 1
    Eigen::VectorXd singularValues; ///< largest first, at most maxOrder
    Index converged = 0; ///< the first so many are exact to rounding; the rest err by 1 % at most
    Eigen::MatrixXd leftVectors; ///< U, r x k
    Eigen::MatrixXd shiftGram; ///< U(0..r-2)^T U(1..r-1), k x k: all that shift invariance needs
    Eigen::MatrixXd shiftedCore; ///< U^T H1 V, k x k; only with step-as-impulse
    Eigen::VectorXd firstRightRow; ///< V(0, :), k; only with step-as-impulse
    std::vector<double> seriesWeights; ///< each series was divided by this (its noise sd)
    double noiseFloor_p95 = 0.0; ///< largest singular value expected of noise alone (95 %)
    double noiseFloor_median = 0.0; ///< its median
    std::string method; ///< "dense" or "lanczos"
};

/// The sequence that the Hankel matrix of a series is built from: the series itself, or its first
/// difference, divided by `weight`.
Eigen::VectorXd hankelSequence(
    const ModelSeries &series, ResponseTreatment treatment, double weight);

/// Singular values whose plot the operator reads the order from (thesis eqs 3.18, 3.19).
Result<HankelDecomposition> decomposeHankel(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control = {});

} // namespace dyncal
