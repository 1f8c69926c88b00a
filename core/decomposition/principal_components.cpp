// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/decomposition/principal_components.h"

#include "core/base/svd.h"

#include <Eigen/QR>

#include <utility>

namespace dyncal {
namespace {

/// X = U S V^T. A QR decomposition first makes the cost linear in the samples; the Gram matrix
/// would too, but would square the condition number.
ThinSvd tallSvd(const Eigen::MatrixXd &X)
{
    if (X.rows() <= X.cols())
        return thinSvd(X);
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(X);
    const Eigen::MatrixXd R = qr.matrixQR().topRows(X.cols()).triangularView<Eigen::Upper>();
    ThinSvd svd = thinSvd(R);
    Eigen::MatrixXd left = Eigen::MatrixXd::Zero(X.rows(), X.cols());
    left.topRows(X.cols()) = svd.left;
    left.applyOnTheLeft(qr.householderQ());
    svd.left = std::move(left);
    return svd;
}

/// Whether the scores of a component should change their sign: the first one's mean is positive,
/// of the others the largest score.
bool isUpsideDown(const Eigen::VectorXd &scores, bool first)
{
    Index largest = 0;
    scores.cwiseAbs().maxCoeff(&largest);
    return (first ? scores.sum() : scores[largest]) < 0.0;
}

} // namespace

PrincipalComponents computePrincipalComponents(const Eigen::MatrixXd &shots, bool centre)
{
    PrincipalComponents result;
    Eigen::MatrixXd X = shots;
    if (centre) {
        result.mean = shots.rowwise().mean();
        X.colwise() -= result.mean;
    }
    ThinSvd svd = tallSvd(X);
    result.scores = svd.singularValues.asDiagonal() * svd.right.transpose();
    for (Index i = 0; i < result.scores.rows(); ++i) {
        if (isUpsideDown(result.scores.row(i), i == 0)) {
            result.scores.row(i) *= -1.0;
            svd.left.col(i) *= -1.0;
        }
    }
    const double total = svd.singularValues.squaredNorm();
    result.explainedCumulative_percent = Eigen::VectorXd::Zero(svd.singularValues.size());
    double sum = 0.0;
    for (Index i = 0; total > 0.0 && i < svd.singularValues.size(); ++i) {
        sum += svd.singularValues[i] * svd.singularValues[i];
        result.explainedCumulative_percent[i] = 100.0 * sum / total;
    }
    result.singularValues = std::move(svd.singularValues);
    result.components = std::move(svd.left);
    return result;
}

Eigen::MatrixXd reconstruct(const PrincipalComponents &components, Index kept)
{
    Eigen::MatrixXd result = components.components.leftCols(kept) * components.scores.topRows(kept);
    if (components.mean.size() > 0)
        result.colwise() += components.mean;
    return result;
}

} // namespace dyncal
