// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/realized_poles.h"

#include "core/base/eigenvalues.h"
#include "core/realization/exponentials/exponential_sum.h"

#include <algorithm>

namespace dyncal {
namespace {

bool isThesis(const HankelDecomposition &decomposition)
{
    return decomposition.shiftedCore.size() > 0;
}

Eigen::MatrixXd shiftInvarianceMatrix(const HankelDecomposition &decomposition, Index order)
{
    const Eigen::VectorXd last
        = decomposition.leftVectors.bottomRows(1).leftCols(order).transpose();
    const Eigen::MatrixXd gram = decomposition.shiftGram.topLeftCorner(order, order);
    return gram + last * (last.transpose() * gram) / (1.0 - last.squaredNorm());
}

} // namespace

Index largestOrder(const HankelDecomposition &decomposition)
{
    // One row of U is lost to the shift.
    return std::min(decomposition.singularValues.size(), decomposition.rows - 1);
}

std::vector<std::complex<double>> realizedPoles(
    const HankelDecomposition &decomposition, Index order)
{
    return pairedPoles(
        eigenvalues(isThesis(decomposition) ? thesisRealization(decomposition, order, 1.0).A
                                            : shiftInvarianceMatrix(decomposition, order)));
}

StateSpaceModel thesisRealization(
    const HankelDecomposition &decomposition, Index order, double sampleInterval_s)
{
    const Eigen::ArrayXd root = decomposition.singularValues.head(order).array().sqrt();
    const Eigen::VectorXd inverse = root.inverse().matrix();
    StateSpaceModel model;
    model.A = inverse.asDiagonal() * decomposition.shiftedCore.topLeftCorner(order, order)
        * inverse.asDiagonal();
    model.B = (root * decomposition.firstRightRow.head(order).array()).matrix();
    model.C = (root * decomposition.leftVectors.row(0).head(order).transpose().array())
                  .matrix()
                  .transpose();
    model.D = Eigen::MatrixXd::Zero(1, 1);
    model.sampleInterval_s = sampleInterval_s;
    return model;
}

} // namespace dyncal
